#include "verification/check/case_file.hpp"
#include "verification/driver/case_list.hpp"
#include "verification/driver/command.hpp"

int main(int argc, char** argv) {
  return talus::verification::verify(talus::verification::all_cases(), TALUS_CATALOGUE, argc, argv,
                                     {talus::verification::case_file(""), TALUS_PROGRAM});
}
