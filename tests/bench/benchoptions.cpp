#include "bench/benchoptions.h"

#include <charconv>

namespace autocuts::bench {

using namespace unwrap;

namespace {

std::optional<int> number(const std::string &text, int lowest, int highest)
{
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < lowest || value > highest)
        return std::nullopt;
    return value;
}

std::optional<UnwrapQuality> quality(const std::string &text)
{
    if (text == "draft")
        return UnwrapQuality::Draft;
    if (text == "standard")
        return UnwrapQuality::Standard;
    if (text == "best")
        return UnwrapQuality::Best;
    return std::nullopt;
}

} // namespace

std::optional<Options> readOptions(const std::vector<std::string> &arguments, std::string &problem)
{
    Options options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string &argument = arguments[i];
        const std::string value = i + 1 < arguments.size() ? arguments[i + 1] : std::string();
        bool understood = true;
        if (argument == "--json") {
            options.json = true;
        } else if (argument == "--no-exact") {
            options.exact = false;
        } else if (argument == "--quality") {
            options.quality = true;
        } else if (argument == "--steps-only") {
            options.stepsOnly = true;
        } else if (argument == "--threads" || argument == "--subdivide") {
            const bool threads = argument == "--threads";
            const auto count = number(value, threads ? 1 : 0, threads ? 256 : 5);
            (threads ? options.threads : options.subdivisions) = count.value_or(1);
            understood = count.has_value();
            ++i;
        } else if (argument == "--map") {
            options.map = quality(value);
            understood = options.map.has_value();
            ++i;
        } else {
            understood = !argument.starts_with("-");
            options.files.push_back(argument);
        }
        if (!understood) {
            problem =
                "cannot understand " + argument + (i < arguments.size() && !value.empty() ? " " + value : "");
            return std::nullopt;
        }
    }
    if (options.files.empty()) {
        problem = "no mesh given";
        return std::nullopt;
    }
    return options;
}

} // namespace autocuts::bench
