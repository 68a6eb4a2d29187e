#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bentur/pounding/response.h"
#include "bentur/report/words.h"

// What motion.js plays, of a row and of buildings in plan alike: samples of what moves, and impacts.
namespace bentur::html {

using Json = nlohmann::ordered_json;

/// A step of histories [s] by which a page has a sample of even a short impact and does not become too large.
/// @param rows how many move
[[nodiscard]] double motion_step(double duration, Eigen::Index rows);

/// Which of the samples of histories a page has.
struct MotionSampling {
  Eigen::Index stride = 1;  ///< one in so many
  Eigen::Index count = 0;
  double step = 0;  ///< between those [s]
};
/// @param wanted step [s]
[[nodiscard]] MotionSampling motion_sampling(const std::vector<double>& time, double wanted);

/// Of these times the nearest to the start, the peak and the end of each impact shown and to `instant`, as ascending
/// indices; none where there are no times.
[[nodiscard]] std::vector<Eigen::Index> key_columns(const std::vector<double>& time, const std::vector<Impact>& impacts,
                                                    const std::vector<Eigen::Index>& shown, double instant);

/// Rows of a building, {rows, scale, samples, keys}. A displacement x [length] is kept as the whole number nearest to
/// x/scale, scale = max|x|/32767, 16 bits little endian in base64, the rows of an instant side by side: off by 1.5e-5
/// of the building's peak at most. @param exact the same rows at the keys
[[nodiscard]] Json samples_json(const Eigen::MatrixXd& displacement, const MotionSampling& sampling,
                                const Eigen::MatrixXd& exact);

/// How a picture calls the buildings: {short, key, parts}, with `short` what they are called in short, in `parts`
/// whether that is a part of each name and no number, and in `key` what numbers stand for.
[[nodiscard]] Json names_json(const std::vector<std::string>& names);

/// {words, frames, step, keys, impacts}. @param times of which the keys are @param listed impacts, of any order
/// @param force factor of forces as people read of them
[[nodiscard]] Json played_json(const MotionSampling& sampling, const std::vector<double>& times,
                               const std::vector<Eigen::Index>& keys, const std::vector<Impact>& impacts,
                               std::vector<Eigen::Index> listed, double force, const Words& say);

/// Standard base64 with padding (RFC 4648).
[[nodiscard]] std::string base64(const std::string& bytes);

}  // namespace bentur::html
