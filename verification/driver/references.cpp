#include "verification/driver/references.hpp"

#include <algorithm>
#include <cctype>
#include <regex>

namespace talus::verification {

namespace {

/// A work whose text was not at hand. What the cases use of it is derived and tested here.
std::string unseen(const std::string& text) { return text + " Cited from secondary sources: not at hand."; }

}  // namespace

std::vector<Reference> all_references() {
  return {
      {"ahnert2011",
       "K. Ahnert, M. Mulansky: Odeint - solving ordinary differential equations in C++. AIP Conference Proceedings "
       "1389 (2011) 1586-1589."},
      {"abramowitz1964",
       unseen("M. Abramowitz, I. A. Stegun (eds.): Handbook of Mathematical Functions. National Bureau "
              "of Standards, Washington 1964.")},
      {"alefeld1995",
       "G. E. Alefeld, F. A. Potra, Y. Shi: Algorithm 748: enclosing zeros of continuous functions. ACM Transactions "
       "on "
       "Mathematical Software 21 (1995) 327-344."},
      {"antypov2011", unseen("D. Antypov, J. A. Elliott: On an analytical solution for the damped Hertzian spring. EPL "
                             "94 (2011) 50004.")},
      {"baraff1992", unseen("D. Baraff: Dynamic simulation of non-penetrating rigid bodies. PhD thesis, Cornell "
                            "University, 1992.")},
      {"barnes1999", unseen("M. R. Barnes: Form finding and analysis of tension structures by dynamic relaxation. "
                            "International Journal of Space Structures 14 (1999) 89-104.")},
      {"barr1981", unseen("A. H. Barr: Superquadrics and angle-preserving transformations. IEEE Computer Graphics and "
                          "Applications 1 (1981) 11-23.")},
      {"barker1967", unseen("J. A. Barker, D. Henderson: Perturbation theory and equation of state for fluids: the "
                            "square-well potential; II. A successful theory of liquids. Journal of Chemical Physics 47 "
                            "(1967) 2856-2861, 4714-4721.")},
      {"bartz2022",
       "S. P. Bartz: Coefficient of restitution of a linear dashpot on a rigid surface. arXiv 2204.10917 (2022). Only "
       "the "
       "abstract and introduction were read; the equations are derived here."},
      {"blanes2002", unseen("S. Blanes, P. C. Moan: Practical symplectic partitioned Runge-Kutta and "
                            "Runge-Kutta-Nystrom methods. Journal of Computational and Applied Mathematics 142 (2002) "
                            "313-330.")},
      {"bulirsch1966",
       "R. Bulirsch, J. Stoer: Numerical treatment of ordinary differential equations by extrapolation methods. "
       "Numerische Mathematik 8 (1966) 1-13."},
      {"cash1990",
       "J. R. Cash, A. H. Karp: A variable order Runge-Kutta method for initial value problems with rapidly varying "
       "right-hand sides. ACM Transactions on Mathematical Software 16 (1990) 201-222."},
      {"chen1998",
       unseen("T. Y. Chen, S. C. Cheung, S. M. Yiu: Metamorphic testing: a new approach for generating next test "
              "cases. Technical Report HKUST-CS98-01, Hong Kong University of Science and Technology, 1998.")},
      {"clark2017",
       "A. H. Clark, J. D. Thompson, M. D. Shattuck, N. T. Ouellette, C. S. O'Hern: Critical scaling near the yielding "
       "transition in granular media. arXiv 1706.09465 (2017). The abstract was read."},
      {"clausius1870",
       unseen("R. Clausius: On a mechanical theorem applicable to heat. Philosophical Magazine 40 (1870) "
              "122-127.")},
      {"cowell1910",
       unseen("P. H. Cowell, A. C. D. Crommelin: Investigation of the motion of Halley's comet from 1759 to 1910. "
              "Greenwich Observations for 1909, Appendix, Edinburgh, 1910.")},
      {"chung2011",
       "Y. C. Chung, J. Y. Ooi: Benchmark tests for verifying discrete element modelling codes at particle impact "
       "level. Granular Matter 13 (2011) 643-656. The paper itself was not at hand: its eight tests are given here as "
       "those who rebuilt them tell them (LAMMPS, unittest/granular; Yade; PySPH; Kratos, Basic DEM Benchmarking)."},
      {"cruz2005", unseen("F. da Cruz, S. Emam, M. Prochnow, J.-N. Roux, F. Chevoir: Rheophysics of dense granular "
                          "materials: discrete simulation of plane shear flows. Physical Review E 72 (2005) 021309.")},
      {"cundall1979",
       "P. A. Cundall, O. D. L. Strack: A discrete numerical model for granular assemblies. Geotechnique 29 (1979) "
       "47-65."},
      {"giuli2015",
       "E. DeGiuli, J. N. McElwaine, M. Wyart: Phase diagram for inertial granular flows. arXiv 1509.03512 (2015). The "
       "abstract was read."},
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
      {"feng2004", unseen("Y. T. Feng, D. R. J. Owen: A 2D polygon/polygon contact model: algorithmic aspects. "
                          "Engineering Computations 21 (2004) 265-277.")},
      {"galilei1638",
       unseen("G. Galilei: Discorsi e dimostrazioni matematiche intorno a due nuove scienze. Leiden, 1638.")},
      {"goldsmith1960", unseen("W. Goldsmith: Impact: The Theory and Physical Behaviour of Colliding Solids. Edward "
                               "Arnold, London 1960.")},
      {"haff1983",
       unseen("P. K. Haff: Grain flow as a fluid-mechanical phenomenon. Journal of Fluid Mechanics 134 (1983) "
              "401-430.")},
      {"hairer1993",
       "E. Hairer, S. P. Norsett, G. Wanner: Solving Ordinary Differential Equations I: Nonstiff Problems. 2nd "
       "edition, "
       "Springer, 1993."},
      {"hairer2006",
       "E. Hairer, C. Lubich, G. Wanner: Geometric Numerical Integration: Structure-Preserving Algorithms for Ordinary "
       "Differential Equations. 2nd edition, Springer, 2006."},
      {"henderson1975",
       unseen("D. Henderson: A simple equation of state for hard discs. Molecular Physics 30 (1975) 971-972.")},
      {"henrici1962", unseen("P. Henrici: Discrete Variable Methods in Ordinary Differential Equations. Wiley, 1962.")},
      {"herrmann1982",
       unseen("F. Herrmann, M. Seitz: How does the ball-chain work? American Journal of Physics 50 (1982) 977-981.")},
      {"hertz1882", unseen("H. Hertz: Über die Berührung fester elastischer Körper. Journal für die reine und "
                           "angewandte Mathematik 92 (1882) 156-171.")},
      {"housner1963", unseen("G. W. Housner: The behavior of inverted pendulum structures during earthquakes. Bulletin "
                             "of the Seismological Society of America 53 (1963) 403-417.")},
      {"jenkins1985",
       unseen("J. T. Jenkins, M. W. Richman: Kinetic theory for plane flows of a dense gas of identical, "
              "rough, inelastic, circular disks. Physics of Fluids 28 (1985) 3485-3494.")},
      {"jenkins1988",
       unseen("J. T. Jenkins, M. W. Richman: Plane simple shear of smooth inelastic circular disks: the "
              "anisotropy of the second moment in the dilute and dense limits. Journal of Fluid Mechanics "
              "192 (1988) 313-328.")},
      {"kennedy2003",
       unseen("C. A. Kennedy, M. H. Carpenter: Additive Runge-Kutta schemes for convection-diffusion-reaction "
              "equations. Applied Numerical Mathematics 44 (2003) 139-181.")},
      {"kharaz2001", unseen("A. H. Kharaz, D. A. Gorham, A. D. Salman: An experimental study of the elastic rebound of "
                            "spheres. Powder Technology 120 (2001) 281-291.")},
      {"krogh1974",
       unseen("F. T. Krogh: Changing stepsize in the integration of differential equations using modified divided "
              "differences. Lecture Notes in Mathematics 362, Springer, 1974, 22-71.")},
      {"kovacic2011", unseen("I. Kovacic, M. J. Brennan (eds.): The Duffing Equation: Nonlinear Oscillators and their "
                             "Behaviour. Wiley, 2011.")},
      {"lacy1989",
       "J. M. Lacy: On the transport mechanism of rockfalls and avalanches. M.S. thesis, Montana State University, "
       "Bozeman, April 1989; here \"SNOFLO\", its program. Chapters 1 and 2 and part of 3 were at hand."},
      {"lammps",
       "LAMMPS, unittest/granular/README.md and test_analytic_models.cpp, https://github.com/lammps/lammps, "
       "revisions 0e2cc2a and 10e220f. Only the definitions were read."},
      {"lees1972", unseen("A. W. Lees, S. F. Edwards: The computer study of transport processes under extreme "
                          "conditions. Journal of Physics C 5 (1972) 1921.")},
      {"mfix",
       "MFiX Verification and Validation Manual, chapter 4 (DEM01 to DEM06), "
       "https://mfix.netl.doe.gov/doc/vvuq-manual/main/html/dem/; R. Garg, J. Galvin, T. Li, S. Pannala: Open-source "
       "MFIX-DEM software for gas-solids flows: Part I - Verification studies. Powder Technology 220 (2012) 122-137."},
      {"miller2004",
       "S. Miller, S. Luding: Cluster growth in two- and three-dimensional granular gases. Physical Review E "
       "69 (2004) 031305. Abstract and introduction were read."},
      {"mitarai2007",
       "N. Mitarai, H. Nakanishi: Velocity correlations in the dense granular shear flows: effects on energy "
       "dissipation and normal stress. Physical Review E 75 (2007) 031305; arXiv cond-mat/0611397. The "
       "abstract was read."},
      {"mustoe1993",
       "G. G. W. Mustoe, H. P. Huttelmaier: Analytical Simulation of Rockfall Prevention Fence Structures. Report "
       "CDOT-CSM-R-93-20, Colorado School of Mines for the Colorado Department of Transportation, April 1993, 79 "
       "pages; "
       "here \"the 1993 report\"."},
      {"okabe2008", unseen("M. Okabe, K. Ito: Color Universal Design: how to make figures and presentations that are "
                           "friendly to colorblind people. 2008.")},
      {"peyneau2008",
       "P.-E. Peyneau, J.-N. Roux: Frictionless bead packs have macroscopic friction, but no dilatancy. "
       "Physical Review E 78 (2008) 011307. The abstract was read."},
      {"rayleigh1877", unseen("J. W. Strutt, Baron Rayleigh: The Theory of Sound, volume I. Macmillan, 1877.")},
      {"roache2002",
       "P. J. Roache: Code verification by the method of manufactured solutions. Journal of Fluids Engineering 124 "
       "(2002) 4-10."},
      {"schwager2007",
       "T. Schwager, T. Poschel: Coefficient of restitution and linear-dashpot model revisited. Granular Matter 9 "
       "(2007) "
       "465-469."},
      {"shampine1975",
       unseen("L. F. Shampine, M. K. Gordon: Computer Solution of Ordinary Differential Equations: The Initial "
              "Value Problem. Freeman, San Francisco, 1975.")},
      {"steele1990", unseen("G. L. Steele, J. L. White: How to print floating-point numbers accurately. ACM SIGPLAN "
                            "Notices 25, no. 6 (1990) 112-126.")},
      {"stoermer1907",
       unseen("C. Stoermer: Sur les trajectoires des corpuscules electrises. Archives des sciences physiques et "
              "naturelles 24 (1907) 5-18, 113-158, 221-247.")},
      {"swope1982",
       "W. C. Swope, H. C. Andersen, P. H. Berens, K. R. Wilson: A computer simulation method for the calculation of "
       "equilibrium constants for the formation of physical clusters of molecules. Journal of Chemical Physics 76 "
       "(1982) "
       "637-649."},
      {"tsuji1992", unseen("Y. Tsuji, T. Tanaka, T. Ishida: Lagrangian numerical simulation of plug flow of "
                           "cohesionless particles in a horizontal pipe. Powder Technology 71 (1992) 239-250.")},
      {"vagberg2015",
       "D. Vagberg, P. Olsson, S. Teitel: Critical scaling of Bagnold rheology at the jamming transition of "
       "frictionless "
       "two-dimensional disks. arXiv 1510.03312 (2015). The abstract was read."},
      {"verlet1967",
       "L. Verlet: Computer \"experiments\" on classical fluids. I. Thermodynamical properties of Lennard-Jones "
       "molecules. Physical Review 159 (1967) 98-103."},
      {"vyas2025",
       "D. R. Vyas, J. M. Ottino, R. M. Lueptow, P. B. Umbanhowar: Improved velocity-Verlet algorithm for the discrete "
       "element method. Computer Physics Communications 310 (2025) 109524."},
      {"walton1986",
       unseen("O. R. Walton, R. L. Braun: Viscosity, granular-temperature, and stress calculations for shearing "
              "assemblies of inelastic, frictional disks. Journal of Rheology 30 (1986) 949-980.")},
      {"welch1947", unseen("B. L. Welch: The generalization of \"Student's\" problem when several different population "
                           "variances are involved. Biometrika 34 (1947) 28-35.")},
      {"whittaker1937", unseen("E. T. Whittaker: A Treatise on the Analytical Dynamics of Particles and Rigid Bodies. "
                               "4th edition, Cambridge University Press, 1937.")},
  };
}

std::vector<std::string> citations_without_entry(const std::string& text) {
  const std::regex name_or_year{R"([A-Z][a-z]+|\b(1[5-9]|20)\d\d\b|;)"};
  const auto references = all_references();
  std::vector<std::string> names, missing;
  for (std::sregex_iterator it{text.begin(), text.end(), name_or_year}, end; it != end; ++it) {
    std::string word = it->str();
    if (word == ";") {
      names.clear();
    } else if (std::isdigit(static_cast<unsigned char>(word.front())) == 0) {
      word.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(word.front())));
      names.push_back(word);
    } else if (std::none_of(references.begin(), references.end(), [&](const Reference& reference) {
                 return std::any_of(names.begin(), names.end(),
                                    [&](const std::string& name) { return reference.key == name + word; });
               })) {
      missing.push_back((names.empty() ? "" : names.front() + " ") + word);
    }
  }
  return missing;
}

}  // namespace talus::verification
