#pragma once

#include <array>
#include <string>
#include <string_view>

#include "bentur/files/netcdf.h"
#include "bentur/model/run_results.h"

namespace bentur {

/// Of the forces at the ends of a struck column, in the order of StructuralModel::column_forces: a name in NetCDF.
struct ColumnEndName {
  std::string_view name, long_name;
  bool is_moment = false;
};
inline constexpr std::array<ColumnEndName, 6> column_ends = {{
    {"node_shear_below", "shear of struck columns below the node", false},
    {"node_shear_above", "shear of struck columns above the node", false},
    {"node_moment_bottom", "moment at the bottom of struck columns", true},
    {"node_moment_below", "moment of struck columns at the node, of the piece below it", true},
    {"node_moment_above", "moment of struck columns at the node, of the piece above it", true},
    {"node_moment_top", "moment at the top of struck columns", true},
}};

/// Writes `point_left` and `point_right`, the names of the buildings on both sides of each contact point.
void write_point_sides(const NetcdfWriter& file, NetcdfWriter::Dimension points, const Problem& problem);

/// Writes `link_left` and `link_right`, and `link_elevation` where a unit of length is given.
void write_link_places(const NetcdfWriter& file, NetcdfWriter::Dimension links, const Problem& problem,
                       const std::string& length);

/// `histories.nc` as bytes: NetCDF-4, CF conventions, opens in xarray. Dimensions `time`, `elevation_N` for building N
/// (1 the leftmost) with the floors' elevations as coordinate, `point` for the contact points, `link`
/// for the links. Variables
/// `displacement_N`, `velocity_N`, `acceleration_N` (absolute), `drift_ratio_N`, `storey_shear_N` (storeys, each by the
/// floor above it), `base_shear_N`, `opening`, `force`, `ground_acceleration`, with an
/// energy audit also `energy_input`, `energy_kinetic`, `energy_strain`, `energy_damping`, `energy_hysteretic`,
/// `energy_contact_stored`,
/// `energy_contact_lost`; of every building `period_N`, `shape_N` and the peaks of its floors; of every impact
/// `impact_start` and the rest of impacts.csv that figures need; with `figures` its contents as `close_up_*` and
/// `spectrum_*`. Each with units and long_name. The same histories give the same bytes.
/// @throws std::runtime_error with the library's reason.
[[nodiscard]] std::string histories_netcdf(const RunResults& results, std::string_view version);

}  // namespace bentur
