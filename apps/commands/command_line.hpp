#pragma once

namespace seiche::apps {

/// The whole program: reads the command line, does what it asks for, and returns what the program exits with.
int command_line(int argc, char** argv);

}  // namespace seiche::apps
