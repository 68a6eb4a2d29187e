#include "bentur/solve/motion/embedded_pair.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

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

/// The interpolant is y₀ + Σ F_i b_i(s) with b₀ = s, b₁ = s(1 − s), b₂ = s²(1 − s), …; its powers of s.
const std::array<std::array<double, 8>, 7>& basis_powers() {
  static const auto powers = [] {
    std::array<std::array<double, 8>, 7> result{};
    std::array<double, 8> b{};
    b[1] = 1.0;
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = b;
      std::array<double, 8> times_s{};
      for (std::size_t k = 0; k + 1 < b.size(); ++k) times_s[k + 1] = b[k];
      if (i % 2 == 0) {
        for (std::size_t k = 0; k < b.size(); ++k) b[k] -= times_s[k];
      } else {
        b = times_s;
      }
    }
    return result;
  }();
  return powers;
}

}  // namespace

EmbeddedPair::EmbeddedPair(const ModalSystem& system, double tolerance)
    : system_(&system),
      tolerance_(tolerance),
      speed_(MatrixXd::Zero(system.size, all_stages)),
      rate_(MatrixXd::Zero(system.size, all_stages)),
      forces_(static_cast<Index>(system.points.size())) {}

/// Slopes of stage i, from those before it.
void EmbeddedPair::stage(int i, const ForceFunction& forces) {
  double* q = at_.q.data() + begin_;
  double* v = at_.v.data() + begin_;
  std::copy_n(start_.q.data() + begin_, count_, q);
  std::copy_n(start_.v.data() + begin_, count_, v);
  if (i > 0) {
    const auto& row = weights[static_cast<std::size_t>(i - 1)];
    for (int j = 0; j < i; ++j) {
      const double weight = h_ * row[static_cast<std::size_t>(j)];
      if (weight == 0.0) continue;
      const double* speed = speed_.col(j).data() + begin_;
      const double* rate = rate_.col(j).data() + begin_;
      for (Index k = 0; k < count_; ++k) {
        q[k] += weight * speed[k];
        v[k] += weight * rate[k];
      }
    }
  }
  inputs_at_ = *inputs_;
  system_->advance(inputs_at_, nodes[static_cast<std::size_t>(i)] * h_);
  forces(at_, inputs_at_, forces_);
  system_->acceleration(at_, inputs_at_, forces_, acceleration_);
  std::copy_n(v, count_, speed_.col(i).data() + begin_);
  std::copy_n(acceleration_.data() + begin_, count_, rate_.col(i).data() + begin_);
}

double EmbeddedPair::step(const State& from, const std::vector<GroundInput>& inputs, double h, BuildingRange range,
                          const ForceFunction& forces, State& to) {
  inputs_ = &inputs;
  h_ = h;
  begin_ = system_->blocks[range.first].begin;
  count_ = system_->blocks[range.end - 1].begin + system_->blocks[range.end - 1].size - begin_;
  start_ = from;
  at_ = from;
  for (int i = 0; i <= stages; ++i) stage(i, forces);
  to.q.segment(begin_, count_) = at_.q.segment(begin_, count_);
  to.v.segment(begin_, count_) = at_.v.segment(begin_, count_);

  // The error of order 5, e_q = h five_q taken as e_q/h and e_v = h five_v, and that of order 3 alike; the motion's
  // size.
  double five = 0.0, three = 0.0, before = 0.0, after = 0.0, change = 0.0;
  for (Index k = begin_; k < begin_ + count_; ++k) {
    double five_q = 0.0, five_v = 0.0, three_q = 0.0, three_v = 0.0;
    for (int j = 0; j < stages; ++j) {
      const auto n = static_cast<std::size_t>(j);
      five_q += error_five[n] * speed_(k, j);
      five_v += error_five[n] * rate_(k, j);
      three_q += error_three[n] * speed_(k, j);
      three_v += error_three[n] * rate_(k, j);
    }
    five += five_q * five_q + h * h * five_v * five_v;
    three += three_q * three_q + h * h * three_v * three_v;
    const double w2 = system_->omega_squared(k);
    before += from.v(k) * from.v(k) + w2 * from.q(k) * from.q(k);
    after += to.v(k) * to.v(k) + w2 * to.q(k) * to.q(k);
    change += h * h * rate_(k, 0) * rate_(k, 0);
  }
  if (five == 0.0 && three == 0.0) return 0.0;
  const double size = std::sqrt(std::max({before, after, change}));
  return five / std::sqrt(five + 0.01 * three) / (tolerance_ * size);
}

void EmbeddedPair::expand(const ForceFunction& forces, Expansion& motion) {
  for (int i = stages + 1; i < all_stages; ++i) stage(i, forces);
  // v is interpolated, and q is its integral.
  auto& c = motion.coefficients();
  const auto& powers = basis_powers();
  for (Index k = begin_; k < begin_ + count_; ++k) {
    std::array<double, 7> f{};
    for (int j = 0; j < stages; ++j) f[0] += h_ * weights[stages - 1][static_cast<std::size_t>(j)] * rate_(k, j);
    f[1] = h_ * rate_(k, 0) - f[0];
    f[2] = 2.0 * f[0] - h_ * (rate_(k, stages) + rate_(k, 0));
    for (std::size_t i = 0; i < interpolant.size(); ++i) {
      for (int j = 0; j < all_stages; ++j) f[3 + i] += h_ * interpolant[i][static_cast<std::size_t>(j)] * rate_(k, j);
    }
    c(k, 0) = start_.q(k);
    c(k, 1) = h_ * start_.v(k);
    for (int n = 1; n < degree; ++n) {
      double power = 0.0;
      for (std::size_t i = 0; i < f.size(); ++i) power += powers[i][static_cast<std::size_t>(n)] * f[i];
      c(k, n + 1) = power * (h_ / (n + 1.0));
    }
    for (int n = degree + 1; n <= highest_degree; ++n) c(k, n) = 0.0;
  }
}

}  // namespace bentur::engine
