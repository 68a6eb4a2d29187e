#include "bentur/solve/engine/motion/runge_kutta/embedded_pair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Coefficients of DOP853 [HairerNorsettWanner1993]: row i of `weights` makes stage i + 1 of those before it; row 11 is
// the result of order 8 (stage 12 its slope), rows 12 to 14 are for the interpolant alone.
constexpr std::array<double, 16> nodes = {0,
                                          0.05260015195876773,
                                          0.0789002279381516,
                                          0.1183503419072274,
                                          0.2816496580927726,
                                          0.3333333333333333,
                                          0.25,
                                          0.3076923076923077,
                                          0.6512820512820513,
                                          0.6,
                                          0.8571428571428571,
                                          1.0,
                                          1.0,
                                          0.1,
                                          0.2,
                                          0.7777777777777778};
constexpr std::array<std::array<double, 15>, 15> weights = {
    {{0.05260015195876773},
     {0.0197250569845379, 0.0591751709536137},
     {0.02958758547680685, 0, 0.08876275643042054},
     {0.2413651341592667, 0, -0.8845494793282861, 0.924834003261792},
     {0.037037037037037035, 0, 0, 0.17082860872947386, 0.12546768756682242},
     {0.037109375, 0, 0, 0.17025221101954405, 0.06021653898045596, -0.017578125},
     {0.03709200011850479, 0, 0, 0.17038392571223998, 0.10726203044637328, -0.015319437748624402, 0.008273789163814023},
     {0.6241109587160757, 0, 0, -3.3608926294469414, -0.868219346841726, 27.59209969944671, 20.154067550477894,
      -43.48988418106996},
     {0.47766253643826434, 0, 0, -2.4881146199716677, -0.590290826836843, 21.230051448181193, 15.279233632882423,
      -33.28821096898486, -0.020331201708508627},
     {-0.9371424300859873, 0, 0, 5.186372428844064, 1.0914373489967295, -8.149787010746927, -18.52006565999696,
      22.739487099350505, 2.4936055526796523, -3.0467644718982196},
     {2.273310147516538, 0, 0, -10.53449546673725, -2.0008720582248625, -17.9589318631188, 27.94888452941996,
      -2.8589982771350235, -8.87285693353063, 12.360567175794303, 0.6433927460157636},
     {0.054293734116568765, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003, -5.801203960010585, 0.3111643669578199,
      -0.1521609496625161, 0.20136540080403034, 0.04471061572777259},
     {0.056167502283047954, 0, 0, 0, 0, 0, 0.25350021021662483, -0.2462390374708025, -0.12419142326381637,
      0.15329179827876568, 0.00820105229563469, 0.007567897660545699, -0.008298},
     {0.03183464816350214, 0, 0, 0, 0, 0.028300909672366776, 0.053541988307438566, -0.05492374857139099, 0, 0,
      -0.00010834732869724932, 0.0003825710908356584, -0.00034046500868740456, 0.1413124436746325},
     {-0.42889630158379194, 0, 0, 0, 0, -4.697621415361164, 7.683421196062599, 4.06898981839711, 0.3567271874552811, 0,
      0, 0, -0.0013990241651590145, 2.9475147891527724, -9.15095847217987}}};
constexpr std::array<double, 12> error_five = {0.01312004499419488,
                                               0,
                                               0,
                                               0,
                                               0,
                                               -1.2251564463762044,
                                               -0.4957589496572502,
                                               1.6643771824549864,
                                               -0.35032884874997366,
                                               0.3341791187130175,
                                               0.08192320648511571,
                                               -0.022355307863886294};
constexpr std::array<double, 12> error_three = {-0.18980075407240762,
                                                0,
                                                0,
                                                0,
                                                0,
                                                4.450312892752409,
                                                1.8915178993145003,
                                                -5.801203960010585,
                                                -0.4226823213237919,
                                                -0.1521609496625161,
                                                0.20136540080403034,
                                                0.02265179219836082};
constexpr std::array<std::array<double, 16>, 4> interpolant = {
    {{-8.428938276109013, 0, 0, 0, 0, 0.5667149535193777, -3.0689499459498917, 2.38466765651207, 2.117034582445028,
      -0.871391583777973, 2.2404374302607883, 0.6315787787694688, -0.08899033645133331, 18.148505520854727,
      -9.194632392478356, -4.436036387594894},
     {10.427508642579134, 0, 0, 0, 0, 242.28349177525817, 165.20045171727028, -374.5467547226902, -22.113666853125306,
      7.733432668472264, -30.674084731089398, -9.332130526430229, 15.697238121770845, -31.139403219565178,
      -9.35292435884448, 35.81684148639408},
     {19.985053242002433, 0, 0, 0, 0, -387.0373087493518, -189.17813819516758, 527.8081592054236, -11.57390253995963,
      6.8812326946963, -1.0006050966910838, 0.7777137798053443, -2.778205752353508, -60.19669523126412,
      84.32040550667716, 11.99229113618279},
     {-25.69393346270375, 0, 0, 0, 0, -154.18974869023643, -231.5293791760455, 357.6391179106141, 93.40532418362432,
      -37.45832313645163, 104.0996495089623, 29.8402934266605, -43.53345659001114, 96.32455395918828,
      -39.17726167561544, -149.72683625798564}}};

constexpr int stages = 12;
constexpr int all_stages = 16;
constexpr int speed_degree = kernels::powers - 1;  // of the interpolant of v
constexpr double worst_place = 0.7;                // of a step: there the interpolant is farthest from (T-1)
constexpr double defect_over_error = 100.0;        // what is allowed there, over the error of a step

/// What follows from the coefficients for q̈ = a(t, q, v).
struct Tables {
  std::array<std::array<double, 15>, 15> position{};  ///< h² (a²)_ij, rows as in `weights`
  std::array<double, 12> five_q{}, three_q{};         ///< h² times: the errors of q
  /// v = v₀ + h Σ_j v̇_j Σ_n power_jn sⁿ: the interpolant y₀ + Σ F_i b_i(s), b₀ = s, b₁ = s(1 − s), b₂ = s²(1 − s), …,
  /// in powers of s, with F₀ = y₁ − y₀, F₁ = h f₀ − F₀, F₂ = 2F₀ − h (f₀ + f₁), F₃ … F₆ = h Σ interpolant_ij f_j.
  std::array<std::array<double, speed_degree + 1>, all_stages> power{};

  Tables() {
    for (std::size_t i = 0; i < weights.size(); ++i) {
      for (std::size_t l = 0; l < i; ++l) {
        for (std::size_t j = 0; j <= l; ++j) position[i][j] += weights[i][l + 1] * weights[l][j];
      }
    }
    for (std::size_t l = 1; l < five_q.size(); ++l) {
      for (std::size_t j = 0; j < l; ++j) {
        five_q[j] += error_five[l] * weights[l - 1][j];
        three_q[j] += error_three[l] * weights[l - 1][j];
      }
    }
    std::array<std::array<double, all_stages>, 7> f{};
    for (std::size_t j = 0; j < stages; ++j) f[0][j] = weights[stages - 1][j];
    for (std::size_t j = 0; j < all_stages; ++j) {
      f[1][j] = -f[0][j];
      f[2][j] = 2.0 * f[0][j];
      for (std::size_t i = 0; i < interpolant.size(); ++i) f[3 + i][j] = interpolant[i][j];
    }
    f[1][0] += 1.0;
    f[2][0] -= 1.0;
    f[2][stages] -= 1.0;
    std::array<double, speed_degree + 1> b{};
    b[1] = 1.0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      for (std::size_t j = 0; j < all_stages; ++j) {
        for (std::size_t n = 0; n < b.size(); ++n) power[j][n] += f[i][j] * b[n];
      }
      auto times_s = b;
      for (std::size_t n = b.size() - 1; n > 0; --n) times_s[n] = b[n - 1];
      times_s[0] = 0.0;
      for (std::size_t n = 0; n < b.size(); ++n) b[n] = i % 2 == 0 ? b[n] - times_s[n] : times_s[n];
    }
  }
};

/// Calls work(coordinate, width) for coordinates from `first` on, four at a time while there are as many: sums over
/// stages then stay in a processor's registers.
template <class Work>
void by_fours(Index first, Index count, const Work& work) {
  Index k = first;
  for (; k + 4 <= first + count; k += 4) work(k, std::integral_constant<int, 4>());
  for (; k < first + count; ++k) work(k, std::integral_constant<int, 1>());
}

template <int width>
using Lane = Eigen::Array<double, width, 1>;

template <int width>
Lane<width> lane(const MatrixXd& matrix, Index row, int column) {
  return Eigen::Map<const Lane<width>>(matrix.col(column).data() + row);
}

const Tables& tables() {
  static const Tables result;
  return result;
}

}  // namespace

EmbeddedPair::EmbeddedPair(const ModalSystem& system, double tolerance)
    : system_(&system),
      tolerance_(tolerance),
      rate_(MatrixXd::Zero(system.size, all_stages)),
      forces_(std::ssize(system.elements)),
      slope_(VectorXd::Zero(system.size)) {}

/// Slope of stage i, from those before it.
void EmbeddedPair::stage(int i, const ForceFunction& forces) {
  const double after = nodes[i] * h_;
  const auto* speeds = i > 0 ? weights[i - 1].data() : nullptr;
  const auto* positions = i > 0 ? tables().position[i - 1].data() : nullptr;
  kernels::stage(count_, rate_.data() + begin_, rate_.rows(), i, positions, speeds, after, h_, start_.q.data() + begin_,
                 start_.v.data() + begin_, at_.q.data() + begin_, at_.v.data() + begin_);
  inputs_at_ = *inputs_;
  system_->advance(inputs_at_, after);
  forces(at_, inputs_at_, forces_);
  system_->acceleration(at_, inputs_at_, forces_, acceleration_);
  std::copy_n(acceleration_.data() + begin_, count_, rate_.col(i).data() + begin_);
}

double EmbeddedPair::step(const State& from, const std::vector<GroundInput>& inputs, double h, BodyRange range,
                          const ForceFunction& forces, State& to) {
  inputs_ = &inputs;
  h_ = h;
  begin_ = system_->blocks[range.first].begin;
  count_ = system_->blocks[range.end - 1].begin + system_->blocks[range.end - 1].padded_size - begin_;
  start_ = from;
  at_ = from;
  for (int i = 0; i <= stages; ++i) stage(i, forces);
  to.q.segment(begin_, count_) = at_.q.segment(begin_, count_);
  to.v.segment(begin_, count_) = at_.v.segment(begin_, count_);

  // The errors of order 5, e_q/h and e_v, and those of order 3 alike; the motion's size.
  const Tables& table = tables();
  double five = 0.0;
  double three = 0.0;
  by_fours(begin_, count_, [&](Index k, auto width) {
    using L = Lane<width()>;
    L five_q = L::Zero(), five_v = L::Zero(), three_q = L::Zero(), three_v = L::Zero();
    for (int n = 0; n < stages; ++n) {
      const L rate = lane<width()>(rate_, k, n);
      five_q += table.five_q[n] * rate;
      five_v += error_five[n] * rate;
      three_q += table.three_q[n] * rate;
      three_v += error_three[n] * rate;
    }
    const L of_mode = Eigen::Map<const L>(system_->of_mode.data() + k);
    five += h * h * (of_mode * (five_q.square() + five_v.square())).sum();
    three += h * h * (of_mode * (three_q.square() + three_v.square())).sum();
  });
  size_ = 0.0;
  if (five == 0.0 && three == 0.0) return 0.0;
  const auto of_mode = system_->of_mode.segment(begin_, count_).array();
  const auto omega_squared = system_->omega_squared.segment(begin_, count_).array();
  const auto energy = [&](const State& state) {
    return (of_mode * state.v.segment(begin_, count_).array().square() +
            omega_squared * state.q.segment(begin_, count_).array().square())
        .sum();
  };
  const double change = h * h * (of_mode * rate_.col(0).segment(begin_, count_).array().square()).sum();
  double driven = 0.0;  // by the ground, even where contacts hold what it drives
  for (Index b = range.first; b < range.end; ++b) {
    const ModalSystem::Block& block = system_->blocks[b];
    for (Index c = 0; c < system_->components(); ++c) {
      const double value = system_->of_body(inputs, b)[c].value;
      driven += system_->gamma.col(c).segment(block.begin, block.modes).squaredNorm() * value * value;
    }
  }
  size_ = std::sqrt(std::max({energy(from), energy(to), change, h * h * driven}));
  return five / std::sqrt(five + 0.01 * three) / (tolerance_ * size_);
}

void EmbeddedPair::expand(const ForceFunction& forces, Expansion& motion) {
  for (int i = stages + 1; i < all_stages; ++i) stage(i, forces);
  // v is interpolated, and q is its integral.
  const Tables& table = tables();
  auto& c = motion.coefficients();
  c.block(begin_, degree + 1, count_, highest_degree - degree).setZero();
  std::array<double, speed_degree + 1> factors{};
  for (std::size_t n = 0; n < factors.size(); ++n) factors[n] = h_ * h_ / (static_cast<double>(n) + 1.0);
  kernels::interpolate(count_, rate_.data() + begin_, rate_.rows(), all_stages, table.power[0].data(), factors.data(),
                       c.col(1).data() + begin_);
  c.col(0).segment(begin_, count_) = start_.q.segment(begin_, count_);
  c.col(1).segment(begin_, count_) = h_ * start_.v.segment(begin_, count_);
}

double EmbeddedPair::defect(const ForceFunction& forces, const Expansion& motion) {
  if (size_ == 0.0) return 0.0;
  motion.evaluate(worst_place, at_, &slope_);
  inputs_at_ = *inputs_;
  system_->advance(inputs_at_, worst_place * h_);
  forces(at_, inputs_at_, forces_);
  system_->acceleration(at_, inputs_at_, forces_, acceleration_);
  const auto apart = (slope_ - acceleration_).segment(begin_, count_).array();
  const double square = (system_->of_mode.segment(begin_, count_).array() * apart.square()).sum();
  return h_ * std::sqrt(square) / (defect_over_error * tolerance_ * size_);
}

}  // namespace bentur::engine
