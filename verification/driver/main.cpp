#include "verification/driver/case_list.hpp"
#include "verification/driver/command.hpp"

int main(int argc, char** argv) {
  return talus::verification::verify(talus::verification::all_cases(), TALUS_CATALOGUE, argc, argv,
                                     {TALUS_CASES, TALUS_PROGRAM});
}
