#include "verification/driver/references.hpp"

namespace talus::verification {

std::vector<Reference> all_references() {
  return {
      {"ahnert2011",
       "K. Ahnert, M. Mulansky: Odeint - solving ordinary differential equations in C++. AIP Conference Proceedings "
       "1389 (2011) 1586-1589."},
      {"alefeld1995",
       "G. E. Alefeld, F. A. Potra, Y. Shi: Algorithm 748: enclosing zeros of continuous functions. ACM Transactions "
       "on "
       "Mathematical Software 21 (1995) 327-344."},
      {"bulirsch1966",
       "R. Bulirsch, J. Stoer: Numerical treatment of ordinary differential equations by extrapolation methods. "
       "Numerische Mathematik 8 (1966) 1-13."},
      {"cash1990",
       "J. R. Cash, A. H. Karp: A variable order Runge-Kutta method for initial value problems with rapidly varying "
       "right-hand sides. ACM Transactions on Mathematical Software 16 (1990) 201-222."},
      {"chung2011",
       "Y. C. Chung, J. Y. Ooi: Benchmark tests for verifying discrete element modelling codes at particle impact "
       "level. Granular Matter 13 (2011) 643-656. The paper itself was not at hand: its eight tests are given here as "
       "those who rebuilt them tell them (LAMMPS, unittest/granular; Yade; PySPH; Kratos, Basic DEM Benchmarking)."},
      {"cundall1979",
       "P. A. Cundall, O. D. L. Strack: A discrete numerical model for granular assemblies. Geotechnique 29 (1979) "
       "47-65."},
      {"dlmf",
       "NIST Digital Library of Mathematical Functions, https://dlmf.nist.gov/, chapters 19 (elliptic integrals) and "
       "22 "
       "(Jacobian elliptic functions)."},
      {"dormand1980",
       "J. R. Dormand, P. J. Prince: A family of embedded Runge-Kutta formulae. Journal of Computational and Applied "
       "Mathematics 6 (1980) 19-26."},
      {"fehlberg1968",
       "E. Fehlberg: Classical fifth-, sixth-, seventh-, and eighth-order Runge-Kutta formulas with stepsize control. "
       "NASA Technical Report R-287, 1968."},
      {"hairer1993",
       "E. Hairer, S. P. Norsett, G. Wanner: Solving Ordinary Differential Equations I: Nonstiff Problems. 2nd "
       "edition, "
       "Springer, 1993."},
      {"hairer2006",
       "E. Hairer, C. Lubich, G. Wanner: Geometric Numerical Integration: Structure-Preserving Algorithms for Ordinary "
       "Differential Equations. 2nd edition, Springer, 2006."},
      {"lammps",
       "LAMMPS, unittest/granular/README.md and test_analytic_models.cpp, https://github.com/lammps/lammps, "
       "revisions 0e2cc2a and 10e220f. Only the definitions were read."},
      {"mfix",
       "MFiX Verification and Validation Manual, chapter 4 (DEM01 to DEM06), "
       "https://mfix.netl.doe.gov/doc/vvuq-manual/main/html/dem/; R. Garg, J. Galvin, T. Li, S. Pannala: Open-source "
       "MFIX-DEM software for gas-solids flows: Part I - Verification studies. Powder Technology 220 (2012) 122-137."},
      {"mustoe1993",
       "G. G. W. Mustoe, H. P. Huttelmaier: Analytical Simulation of Rockfall Prevention Fence Structures. Report "
       "CDOT-CSM-R-93-20, Colorado School of Mines for the Colorado Department of Transportation, April 1993, 79 "
       "pages; "
       "here \"the 1993 report\"."},
      {"roache2002",
       "P. J. Roache: Code verification by the method of manufactured solutions. Journal of Fluids Engineering 124 "
       "(2002) 4-10."},
      {"schwager2007",
       "T. Schwager, T. Poschel: Coefficient of restitution and linear-dashpot model revisited. Granular Matter 9 "
       "(2007) "
       "465-469."},
      {"swope1982",
       "W. C. Swope, H. C. Andersen, P. H. Berens, K. R. Wilson: A computer simulation method for the calculation of "
       "equilibrium constants for the formation of physical clusters of molecules. Journal of Chemical Physics 76 "
       "(1982) "
       "637-649."},
      {"verlet1967",
       "L. Verlet: Computer \"experiments\" on classical fluids. I. Thermodynamical properties of Lennard-Jones "
       "molecules. Physical Review 159 (1967) 98-103."},
      {"vyas2025",
       "D. R. Vyas, J. M. Ottino, R. M. Lueptow, P. B. Umbanhowar: Improved velocity-Verlet algorithm for the discrete "
       "element method. Computer Physics Communications 310 (2025) 109524."},
  };
}

}  // namespace talus::verification
