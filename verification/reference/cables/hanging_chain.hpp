#pragma once

#include <vector>

/// Static equilibrium of a chain of equal links between two points, with equal weights at its n joints:
///
///     (0,0)o                         o (a, b)       link i = 0 ... n from joint i to i + 1, joints 1 ... n loaded
///           \                     /
///             o-- o -- ... -- o--
///             |W  |W          |W
///
/// Joint i is in equilibrium if the link pull (H, V_i) has the same H everywhere and V_i = V_0 + i W. A link of length
/// l and compliance c = 1/k lies along its pull T_i = sqrt(H^2 + V_i^2) and is l + c T_i long, so that
///   sum_i (l/T_i + c) (H, V_i) = (a, b):
/// two equations for H and V_0, the gradient of the convex sum_i (l T_i + c T_i^2/2) - a H - b V_0, solved by Newton's
/// method with step halving at 50 digits. c = 0 is the discrete catenary. The positions are the partial sums. With J
/// the Jacobian at c = 0, d(H, V_0)/dc = -J^-1 sum_i (H, V_i) gives the rate at which they change with c.
namespace talus::verification::reference {

struct HangingChain {
  int joints{};     ///< n >= 1 loaded joints
  double link{};    ///< l [L] > 0; (n + 1) l greater than the distance between the ends
  double weight{};  ///< W of each joint [F] > 0, downwards
  double span{};    ///< a [L] > 0
  double rise{};    ///< b [L], of the right end over the left
};

/// Joints 1 ... n from the left end [L], and link pulls 0 ... n [F].
struct HungChain {
  std::vector<double> x, y;
  std::vector<double> tension;
};

/// Static chain with links of compliance c [L/F] >= 0; std::invalid_argument if there is no such equilibrium.
[[nodiscard]] HungChain hung_chain(const HangingChain& chain, double compliance);

/// Derivatives d(x, y)/dc of the joint positions at c = 0 [F], and of the link pulls [F^2/L].
[[nodiscard]] HungChain softening(const HangingChain& chain);

}  // namespace talus::verification::reference
