#pragma once

#include <variant>
#include <vector>

namespace bentur {

/// Horizontal spectrum of ASCE 7-22, 11.4.5.2 (two periods), and of SNI 1726:2019, 6.4, with T_0 = 0.2 S_D1/S_DS and
/// T_S = S_D1/S_DS:
///
///   S_a = S_DS (0.4 + 0.6 T/T_0), T < T_0;   S_DS, T ≤ T_S;   S_D1/T, T ≤ T_L;   S_D1 T_L/T², T > T_L.        (1)
///
/// From memory of the codes: read yours. The spectrum of ASCE 7-22 at many periods (11.4.5.1) is a TableSpectrum.
struct TwoPeriodSpectrum {
  double short_period = 0;  ///< S_DS [length/s²] > 0
  double one_second = 0;    ///< S_D1 [length/s²] > 0
  double long_period = 0;   ///< T_L [s] > S_D1/S_DS
};

/// Horizontal elastic spectrum of EN 1998-1:2004, 3.2.2.2, with the damping correction η:
///
///   S_e = a_g S (1 + T/T_B (2.5 η − 1)), T < T_B;   2.5 a_g S η, T ≤ T_C;   2.5 a_g S η T_C/T, T ≤ T_D;
///   2.5 a_g S η T_C T_D/T², T > T_D.                                              (2) = (3.2) to (3.5) there
///
/// (3.5) holds up to 4 s there; beyond, where Annex A lets displacements fall, it goes on here, which is safe.
struct EurocodeSpectrum {
  double ground_acceleration = 0;                   ///< a_g [length/s²] > 0, the importance factor in it
  double soil_factor = 1;                           ///< S [-] > 0
  double corner_b = 0, corner_c = 0, corner_d = 0;  ///< T_B < T_C < T_D [s] > 0
};

/// S, T_B, T_C, T_D of a ground type, A to E, for spectra of type 1 and 2: tables 3.2 and 3.3 of EN 1998-1:2004, from
/// memory. @throws InvalidParameter when there is none of that name. @param ground_acceleration a_g [length/s²]
[[nodiscard]] EurocodeSpectrum eurocode_spectrum(int type, char ground_type, double ground_acceleration);

/// Ordinates at periods, straight lines between them.
struct TableSpectrum {
  std::vector<double> periods;        ///< [s] ≥ 0, ascending
  std::vector<double> accelerations;  ///< S_a [length/s²] ≥ 0
};

/// Pseudo-accelerations of an elastic oscillator, for a damping ratio of their own.
struct DesignSpectrum {
  std::variant<TwoPeriodSpectrum, EurocodeSpectrum, TableSpectrum> shape;
  double damping_ratio = 0.05;   ///< ζ_s that the ordinates are for [-]
  bool corrects_damping = true;  ///< for other ratios; false: the ordinates hold for all
};

/// η = √(0.10/(0.05 + ζ)) ≥ 0.55, (3.6) of EN 1998-1:2004 [-]. @throws InvalidParameter unless ζ ≥ 0.
[[nodiscard]] double damping_correction(double damping_ratio);

/// S_a(T, ζ) [length/s²]. Ordinates are those for ζ_s times η(ζ)/η(ζ_s); of (2) the η in it. Before the first period of
/// a table the first ordinate. @throws InvalidParameter unless T is finite and > 0, and of a table not beyond its last.
[[nodiscard]] double spectral_acceleration(const DesignSpectrum& spectrum, double period, double damping_ratio);

/// S_d = S_a (T/2π)² [length]. @throws InvalidParameter likewise.
[[nodiscard]] double spectral_displacement(const DesignSpectrum& spectrum, double period, double damping_ratio);

/// The largest ordinate, for the spectrum's own damping ratio [length/s²].
[[nodiscard]] double largest_ordinate(const DesignSpectrum& spectrum);

/// @throws InvalidParameter naming the first parameter that is out of its range.
void validate(const DesignSpectrum& spectrum);

}  // namespace bentur
