#pragma once

#include <functional>
#include <string>

#include "solver/app/sweep/sweep_function.hpp"

namespace talus::server {

/// An answer to a request by HTTP.
struct Answer {
  int status{200};
  std::string body;  ///< JSON
};

/// The protocol of UM-Bridge, version 1.0 (Seelinger et al., J. Open Source Softw. 8 (2023) 4748), for one model with
/// one vector of inputs, the fields of the axes, and one of outputs.
class UmBridge {
 public:
  /// Name of the model.
  static constexpr const char* model = "forward";

  explicit UmBridge(const app::SweepFunction& function) : function_{&function} {}

  /// Answer to GET /Info.
  [[nodiscard]] Answer info() const;
  /// Answer to GET /Quantities, which is not of the protocol and has no room in its answers: names and units of the
  /// inputs and outputs.
  [[nodiscard]] Answer quantities() const;
  /// Answers to POST requests with these bodies. A wrong body, another model or a wrong input has status 400, a run
  /// that fails 500; both with an error that has a type and a message.
  [[nodiscard]] Answer model_info(const std::string& body) const;
  [[nodiscard]] Answer input_sizes(const std::string& body) const;
  [[nodiscard]] Answer output_sizes(const std::string& body) const;
  /// `interrupted`: as of SweepBase::result(); a run that is interrupted fails.
  [[nodiscard]] Answer evaluate(const std::string& body, const std::function<bool()>& interrupted) const;
  /// Answer to Gradient, ApplyJacobian and ApplyHessian, of which there is none.
  [[nodiscard]] Answer unsupported(const std::string& feature, const std::string& body) const;

 private:
  const app::SweepFunction* function_;
};

}  // namespace talus::server
