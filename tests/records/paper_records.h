#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Records on paper: files in the layouts of networks, with headings as theirs and numbers that nobody has measured.
namespace bentur::test {

/// A component: its name in the file and its values in the file's unit.
struct PaperComponent {
  std::string name;
  std::vector<double> values;

  [[nodiscard]] double peak() const {
    double largest = 0;
    for (const double value : values) largest = std::abs(value) > std::abs(largest) ? value : largest;
    return largest;
  }
};

using PaperComponents = std::vector<PaperComponent>;

/// Waves that are largest early on, `peak` once.
inline std::vector<double> paper_waves(std::size_t count, double peak, double turns = 7) {
  std::vector<double> values(count);
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    values[i] = std::sin(6.283185307179586 * turns * t) * std::exp(-2 * t);
    largest = std::max(largest, std::abs(values[i]));
  }
  for (double& value : values) value *= peak / largest;
  return values;
}

/// Numbers as Fortran's (8F10.3) and so on write them: they touch where they are wide. A width that is exceeded drops
/// the zero before the point.
inline std::string paper_fields(const std::vector<double>& values, int in_line, int width, int decimals) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::string field = fmt::format("{:.{}f}", values[i], decimals);
    if (static_cast<int>(field.size()) > width) field.erase(field.find('0'), 1);
    text += fmt::format("{:>{}}", field, width);
    if (static_cast<int>(i) % in_line == in_line - 1 || i + 1 == values.size()) text += "\n";
  }
  return text;
}

inline std::string paper_line_of(std::string_view text, int count) {
  std::string lines;
  for (int i = 0; i < count; ++i) lines += std::string(text) + "\n";
  return lines;
}

/// GeoNet, V1A (uncorrected) or V2A (with velocities and displacements behind the accelerations), mm/s².
inline std::string paper_geonet(const PaperComponents& components, double step, bool corrected) {
  std::string text;
  for (const auto& [name, values] : components) {
    const std::size_t count = values.size();
    const double peak = PaperComponent{name, values}.peak();
    text += fmt::format(
        "{} accelerogram 20200101_000000_TOWN_20 GNS Science\nSite TOWN      40 00 00S  170 00 00E     Basalt file:  "
        "20200101_000000_TOWN\nTown Hall\nInstrument Basalt_1\nResolution: 24-bit   Instr Period: 0.0050 s   Damping: "
        "0.700\nAccelerogram 20200101_000000_TOWN_20                 Processed 2020 February 21\n6 km south of Town\n"
        "2020 January 01          00:00:00 UT\nEpicentre  40 03 27S 170 32 45E  Bearing S15W  Dist   13km  Depth    "
        "9km M "
        " 4.17\nNumber of points {:5}    Duration {:6.2f} {}\n",
        corrected ? "Corrected" : "Uncorrected", count, step * static_cast<double>(count - 1), corrected ? "sec" : "s");
    text += corrected ? fmt::format(
                            "Instrument corrected data at {:.3f} sec intervals\nBand-pass filter transition bands "
                            "are .10-.25 Hz and 24.50-25.50 Hz\nComponent {}  Longitudinal Accelerometer Axis\n"
                            "Acceleration:  peak {:8.1f} mm/s/s at   0.32 sec     rms      2.2 mm/s/s\n",
                            step, name, peak)
                      : fmt::format(
                            "Raw readings in units of 1.00 mm/s/s  at intervals of {:.3f} s\nData is unfiltered\n"
                            "Component {}\nAcceleration:  Peak {:8.1f} mm/s/s at   0.32 s     RMS     1.17 "
                            "mm/s/s\n",
                            step, name, peak);
    text += corrected
                ? "Velocity:      peak     9.99 mm/s   at   0.56 sec     rms     0.09 mm/s\nDisplacement:  peak    "
                  "0.999 mm     at   0.66 sec     rms    0.007 mm\n"
                : "Velocity record unevaluated\nDisplacement record unevaluated\n";
    text += paper_line_of("    2020       1       1      21      15     540       0       0    2020       1", 3);
    const std::size_t others = corrected ? count : 0;
    text += fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}\n", count, 250, 250, count, others, others, 0, 0, 15,
                        17000);
    text += paper_line_of("   200.0    0.70    0.00   0.000  0.0000   0.000   0.000   1.000     0.0    0.00", 6);
    text += paper_fields(values, 10, 8, 1);
    if (corrected)
      text += paper_fields(paper_waves(count, 9.99), 10, 8, 2) + paper_fields(paper_waves(count, 0.9), 10, 8, 3);
  }
  return text;
}

/// AFAD, gal.
inline std::string paper_afad(const PaperComponents& components, double step) {
  std::string peaks, names, rows;
  for (const PaperComponent& one : components) {
    peaks += fmt::format(" ({}) {:.6f}", one.name, std::abs(one.peak()));
    names += fmt::format("{:>13}", one.name);
  }
  const std::size_t count = components[0].values.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (const PaperComponent& one : components) rows += fmt::format("{:13.6f} ", one.values[i]);
    rows += "\r\n";
  }
  return fmt::format(
             "STRONG GROUND MOTION RECORDS OF TURKIYE\r\nPLACE                   : K\xDDRAZ\r\nEARTHQUAKE DATE         "
             ": 2020/01/01 00:00:09 (GMT)\r\nEPICENTER COORDINATES   : 36.91980N-27.44350E\r\nEARTHQUAKE DEPTH (km)   "
             ": "
             "19.44\r\nEARTHQUAKE MAGNITUDE    : 6.5 Mw\r\nSTATION ID              : 0001\r\nSTATION COORDINATES     : "
             "37.87470N-27.59223E\r\nSTATION ALTITUDE (m)    : 66\r\nRECORDER TYPE           : made up\r\nRECORDER "
             "SERIAL NO      : 1\r\nRECORD TIME             : 01/01/2020 00:00:00.000000 (GMT)\r\nNUMBER OF DATA       "
             "   "
             ": {}\r\nSAMPLING INTERVAL (sec) : {}\r\nRAW PGA VALUES (gal)    :{}\r\nCopyright EARTHQUAKE "
             "DEPARTMENT\r\nDISASTER AND EMERGENCY MANAGEMENT PRESIDENCY\r\n{}\r\n",
             count, step, peaks, names) +
         rows;
}

/// ASA 2.0, Gal.
inline std::string paper_asa(const PaperComponents& components, double step) {
  std::string names, steps, counts, peaks, places, durations, rows, titles;
  const std::size_t count = components[0].values.size();
  for (const PaperComponent& one : components) {
    names += "/" + one.name;
    steps += fmt::format("/{}", step);
    counts += fmt::format("/{}", count);
    durations += fmt::format("/{:.2f}", step * static_cast<double>(count));
    peaks += fmt::format("/{:.4f}", one.peak());
    places += "/17";
    titles += fmt::format("{:>10}", one.name);
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (const PaperComponent& one : components) rows += fmt::format("{:10.4f}", one.values[i]);
    rows += "\r\n";
  }
  const std::string ruler = "---------+---------+---------+---------+---------+---------+---------+---------+\r\n";
  return paper_line_of("*****\r", 1) +
         fmt::format(
             "                       INSTITUTO DE NADA\r\n{}ARCHIVO ESTANDAR DE ACELERACION:\r\nVERSION DEL FORMATO    "
             "     "
             "           : 2.0\r\nCOORDENADAS DE LA ESTACION             : 16.84851 LAT. N\r\n                         "
             "    "
             "          : 99.85157 LONG. W\r\nNUMERO DE CANALES                      : 3\r\nORIENTACION C1-C6 "
             "(rumbo;orientacion)  : {}\r\nORIENTACION C7-C12 (rumbo;orientacion) : \r\nVEL. DE MUESTREO, C1-C6 "
             "(muestras/s)   : {}\r\nINTERVALO DE MUESTREO, C1-C6 (s)       : {}\r\nINTERVALO DE MUESTREO, C7-C12 (s)  "
             "  "
             "  : \r\nUMBRAL DE DISPARO, C1-C6 (Gal)         : /4/4/4\r\nDURACION DEL REGISTRO (s), C1-C6       : "
             "{}\r\nNUM. TOTAL DE MUESTRAS, C1-C6          : {}\r\nNUM. TOTAL DE MUESTRAS, C7-C12         : \r\nACEL. "
             "MAX.(Gal), C1-C6                 : {}\r\nACEL. MAX., C1-C6, EN LA MUESTRA       : {}\r\nUNIDADES DE LOS "
             "DATOS                  : Gal (cm/s/s)\r\nFACTOR DE DECIMACION                   : 1\r\nFORMATO DATOS "
             "(FORTRAN,10 campos/dato) : 3F10.4\r\nCOMENTARIOS:\r\n\r\nDATOS DE ACELERACION:\r\n{}   CANAL-1   CANAL-2 "
             "  "
             "CANAL-3\r\n{}\r\n{}",
             paper_line_of("*****\r", 1), names, fmt::format("/{0}/{0}/{0}", 1 / step), steps, durations, counts, peaks,
             places, ruler, titles, ruler) +
         rows;
}

/// CSMIP's volume 1 with pairs of time and g/10, as CDMG and RENADIC have it. Times are given [s].
inline std::string paper_pairs(const PaperComponents& components, const std::vector<double>& times) {
  std::string text;
  int number = 0;
  for (const PaperComponent& one : components) {
    ++number;
    text +=
        "UNCORRECTED ACCELEROGRAM DATA              PROCESSED: NEVER\nNOWHERE 2020\n01/01/2020 3:53:52 (GMT)\n"
        "                                   TRIGGER TIME: 1/1/2020 3:54:12.000 GMT\nSTATION NO.          0.000N    "
        "0.000E  QDR       S/N  1 (3  CHNS OF 3  AT STA)\nTOWN S/N 1\n";
    text += fmt::format(
        "CHAN  {}: {:9}(STA CHN:  {})\nUNIVERSIDAD DE NADA\nHYPOCENTER:   0.000N    0.000E  H=   0.0KM   "
        "ML= 0.00\nINSTR PERIOD = 0.0391 SEC,  DAMPING =0.7000,  SENSITIVITY =1.250 VDC/G\nNO. OF POINTS "
        "={:7}  RECORD LENGTH ={:7.3f} SEC\nUNITS OF UNCOR ACCEL ARE SEC AND G/10.     MAX  ={:7.3f} G, "
        "AT   0.160 SEC\nRMS ACCEL OF COMPLETE RECORD = 0.009 G\n",
        number, one.name, number, times.size(), times.back(), one.peak() / 10);
    text += paper_line_of("    1    1    1    3    3    0    1    0    0    0    0    0    0    0    0    0", 6) +
            "    0    0    0    0\n" +
            paper_line_of("     0.039     0.700   100.000     0.106     0.100     1.250    -0.682    30.160", 6) +
            "     0.000     0.000\n";
    std::vector<double> pairs;
    for (std::size_t i = 0; i < times.size(); ++i) pairs.insert(pairs.end(), {times[i], one.values[i]});
    text += paper_fields(pairs, 10, 7, 3);
    text += fmt::format("/&  ----------  END OF DATA FOR CHANNEL {}  ----------\n", number);
  }
  return text;
}

/// BHRC, volume 1, g/10.
inline std::string paper_bhrc(const PaperComponents& components, double step) {
  std::string text;
  for (const PaperComponent& one : components) {
    const std::size_t count = one.values.size();
    const double duration = step * static_cast<double>(count);
    text += fmt::format(
        "* VOL1DS FILE:  0001/01\nInst Type = SSA-2\nOrigin Time : 2020/01/01   12:23:16\n\n{0}\n       \n"
        "COMP {0}1                                                               \nTown                  "
        "    Station   37.485 N 45.891 E   Altitude 1333m   Azimuth L 324   T 54 \nEpicenter 38.520 N "
        "46.860 E   FD 12 Km mb      Ms      Mw6.1   M        ML   (BHRC   )\nINSTR PERIOD =  .019 SEC   "
        "DAMPING =  .640\nNO. OF POINTS = {1:6}      DURATION = {2:7.3f}                        \nUNITS "
        "ARE SECONDS AND G/10\n       \n",
        one.name, count, duration);
    text += paper_line_of("    0    0    0    0    0    0    0    0    0    0    0    0    0    0", 6) +
            "    0    0    0    0\n  .193424E-01  .640000E+00  .499200E+02  .000000E+00  .100000E+00  .00\n" +
            fmt::format("{:>13}  .000000E+00  .000000E+00  .000000E+00  .000000E+00  .00\n",
                        fmt::format("{:.6E}", 1 / step)) +
            paper_line_of("  .000000E+00  .000000E+00  .000000E+00  .000000E+00  .000000E+00  .00", 4) +
            "  .000000E+00  .000000E+00\n";
    text += paper_fields(one.values, 10, 13, 6) + "/&\n";
  }
  return text;
}

/// K-NET's CSV, gal, with the instrument's offset in the values.
inline std::string paper_knet_csv(const PaperComponents& components, double step, double offset) {
  const std::size_t count = components[0].values.size();
  std::string names, offsets, rows;
  for (const PaperComponent& one : components) {
    names += "," + one.name + "(gal)";
    offsets += fmt::format("{}{:.2f}", offsets.empty() ? "" : ",", offset);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double time = step * static_cast<double>(i);
    rows += fmt::format("2024/01/01 00:00:{:05.2f},{:.2f}", 15 + time, time);
    for (const PaperComponent& one : components) rows += fmt::format(",{:.4f}", one.values[i] + offset);
    rows += "\n";
  }
  return fmt::format(
             "#K-NET CSV\n#Event\n#OriginTime,Latitude,Longitude,Depth(km),Magnitude\n#2024/01/01 00:00:00,36.708,"
             "140.952,32,3.8\n#Station\n#Code,Latitude,Longitude,Height(m)\n#XXX001,37.6389,140.9853,17\n#Record\n"
             "#SamplingFrequency(Hz)\n#{}\n#DurationTime(s)\n#{}\n#Offset\n#{}\n#{}\n#Time,RelativeTime(s){}\n",
             1 / step, step * static_cast<double>(count), names.substr(1), offsets, names) +
         rows;
}

}  // namespace bentur::test
