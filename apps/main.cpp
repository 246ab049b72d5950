#include "apps/command_line.hpp"
#include "apps/wait_policy.hpp"

int main(int argc, char** argv) {
  seiche::apps::choose_passive_waiting(argv);
  return seiche::apps::command_line(argc, argv);
}
