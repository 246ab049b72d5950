#include "apps/commands/command_line.hpp"

int main(int argc, char** argv) { return seiche::apps::command_line(argc, argv); }
