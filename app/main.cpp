#include "app/version.h"  // made by third_party/version.cmake

#include "app/command_line.h"

int main(int argc, char** argv) { return crest::run_command_line(argc, argv, CREST_VERSION); }
