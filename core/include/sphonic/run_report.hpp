#pragma once
#include <sphonic/chart.hpp>
#include <sphonic/result_folder.hpp>
#include <sphonic/simulation.hpp>

namespace sphonic {

/// resolved.json, summary.json, probes.csv, profile.csv and the charts of a finished run.
void write_results(const Case& scene, Simulation& simulation, const ResultFolder& folder);

/// Pressure along x beside the reference, with the two highest crests and troughs magnified below.
/// In 2-D and 3-D: the row of particles through the middle of the box.
Chart pressure_chart(const Case& scene, const Summary& summary, const Profile& profile);

/// The pressure field in 2-D, or in 3-D its layer at the middle of the box, and beside it the difference from the reference.
Chart field_chart(const Case& scene, const Summary& summary, const Profile& profile);

/// Pressure against time at each probe, beside the reference.
Chart probe_chart(const Case& scene, const ProbeRecord& probes);

}    // namespace sphonic
