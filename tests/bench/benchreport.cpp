#include "bench/benchreport.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <fstream>

namespace autocuts::bench {

namespace {

std::string format(const char *pattern, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

std::string machine()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos)
            return line.substr(colon + 2);
    }
    return "unknown";
}

double ratio(double exact, double fast)
{
    return fast > 0 ? exact / fast : 0;
}

//! The smallest of the ratios over the deltas; 0 when one was not reached.
double energyRatio(const MeshReport &report)
{
    double smallest = report.races.empty() ? 0 : 1e300;
    for (const auto &[delta, race] : report.races)
        smallest = std::min(smallest, race.fastSteps > 0 ? ratio(race.exact, race.fast) : 0);
    return smallest;
}

std::string quoted(const std::string &text)
{
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            result += '\\';
        if (static_cast<unsigned char>(c) >= 0x20)
            result += c;
    }
    return result + "\"";
}

} // namespace

std::string asText(const MeshReport &r)
{
    std::string text =
        format("%s, %d triangles\n  step %.3f ms (wall %.3f), exact %.2f ms, ratio %.1f\n"
               "  one value %.3f, derivatives %.3f, direction %.3f ms\n",
               r.mesh.c_str(), r.triangles, r.steps.fast, r.steps.fastWall, r.steps.exact,
               ratio(r.steps.exact, r.steps.fast), r.steps.value, r.steps.derivatives, r.steps.direction);
    for (const auto &[delta, race] : r.races)
        text += format(
            "  delta %g: to the energy of ten exact steps %.1f ms (%d steps), exact %.1f ms, ratio %.1f;"
            " with CHOLMOD's hub factor %.1f ms, ratio %.1f\n",
            delta, race.fast, race.fastSteps, race.exact, ratio(race.exact, race.fast), race.general,
            ratio(race.general, race.fast));
    for (const EditResult &edit : r.edits)
        text += format("  %s: %.2f ms, %.1f steps\n", edit.edit.c_str(), edit.milliseconds, edit.stepRatio);
    if (r.quality)
        text += format("  end of the schedule: fast %.5f +- %.5f in %.1f s, exact %.5f +- %.5f in %.1f s\n",
                       r.quality->fast, r.quality->fastError, r.quality->fastSeconds, r.quality->exact,
                       r.quality->exactError, r.quality->exactSeconds);
    for (const auto &[name, map] :
         {std::pair{"map", &r.map}, {"map by the soup", &r.soupMap}, {"the same, exact", &r.exactSoupMap}}) {
        if (*map)
            text += format("  %s: %.1f s, distortion %.4f, seams %.3f\n", name, (*map)->seconds,
                           (*map)->distortion, (*map)->seamLength);
    }
    return text + format("  peak memory %.0f MB\n", r.memory);
}

std::string asJson(const std::vector<MeshReport> &reports, int threads)
{
    std::string text = "[";
    const std::string processor = machine();
    for (std::size_t i = 0; i < reports.size(); ++i) {
        const MeshReport &r = reports[i];
        text += i > 0 ? ",\n {" : "\n {";
        text += "\"mesh\": " + quoted(r.mesh) +
                format(", \"triangles\": %d, \"threads\": %d", r.triangles, threads) +
                ", \"machine\": " + quoted(processor);
        text += format(", \"step_ms_exact\": %.6g, \"step_ms_fast\": %.6g, \"step_wall_ms_fast\": %.6g",
                       r.steps.exact, r.steps.fast, r.steps.fastWall);
        text += format(", \"step_ratio\": %.6g, \"energy_ratio\": %.6g", ratio(r.steps.exact, r.steps.fast),
                       energyRatio(r));
        text += format(", \"value_ms\": %.6g, \"derivatives_ms\": %.6g, \"direction_ms\": %.6g",
                       r.steps.value, r.steps.derivatives, r.steps.direction);
        text += ", \"races\": [";
        for (std::size_t k = 0; k < r.races.size(); ++k) {
            const auto &[delta, race] = r.races[k];
            text += format("%s{\"delta\": %g, \"exact_ms\": %.6g, \"fast_ms\": %.6g, \"fast_steps\": %d, "
                           "\"cholmod_hub_ms\": %.6g}",
                           k > 0 ? ", " : "", delta, race.exact, race.fast, race.fastSteps, race.general);
        }
        text += "], \"edits\": [";
        for (std::size_t k = 0; k < r.edits.size(); ++k)
            text += (k > 0 ? ", {\"edit\": " : "{\"edit\": ") + quoted(r.edits[k].edit) +
                    format(", \"ms\": %.6g, \"steps\": %.4g}", r.edits[k].milliseconds, r.edits[k].stepRatio);
        text += "]";
        if (r.quality)
            text += format(", \"quality\": {\"fast\": %.8g, \"fast_error\": %.3g, \"fast_seconds\": %.5g, "
                           "\"exact\": %.8g, "
                           "\"exact_error\": %.3g, \"exact_seconds\": %.5g}",
                           r.quality->fast, r.quality->fastError, r.quality->fastSeconds, r.quality->exact,
                           r.quality->exactError, r.quality->exactSeconds);
        for (const auto &[name, map] :
             {std::pair{"map", &r.map}, {"soup_map", &r.soupMap}, {"exact_soup_map", &r.exactSoupMap}}) {
            if (*map)
                text += format(", \"%s_seconds\": %.6g, \"%s_distortion\": %.8g, \"%s_seam_norm\": %.8g",
                               name, (*map)->seconds, name, (*map)->distortion, name, (*map)->seamLength);
        }
        text += format(", \"peak_mb\": %.5g}", r.memory);
    }
    return text + "\n]\n";
}

} // namespace autocuts::bench
