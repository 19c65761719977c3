#pragma once

#include <string>
#include <vector>

namespace talus::verification {

/// A check that another code or a published benchmark set makes, and the requirements that stand for it here.
struct PeerCheck {
  std::string suite;                  ///< Key of a Reference: where its definition was read.
  std::string id;                     ///< Its name there.
  std::string what;                   ///< One line: the set-up.
  std::string form;                   ///< What it is compared with; for discs where the peer has spheres.
  std::vector<std::string> problems;  ///< Ids of Requirement that hold the same in two dimensions; empty: none.
  std::string remark{};               ///< What is other here, or why there is none.
};

/// The closed forms of LAMMPS's granular unit tests, of MFiX's DEM01 to DEM06, and of Chung and Ooi's benchmark set.
[[nodiscard]] std::vector<PeerCheck> all_peer_checks();

}  // namespace talus::verification
