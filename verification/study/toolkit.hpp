/// What nearly every case needs, in one include: formatted text, numbers and containers; scenes and their runs; checks,
/// figures, and the helpers for both. A case includes besides only what its problem is about.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/dynamics/rigid_body_system.hpp"
#include "verification/check/case.hpp"
#include "verification/study/findings/curves.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/findings/predicted_errors.hpp"
#include "verification/study/findings/rows.hpp"
#include "verification/study/runs/phases.hpp"
#include "verification/study/runs/scene_run.hpp"
#include "verification/study/runs/usage.hpp"
#include "verification/study/scenes/scene_builder.hpp"
