#include "model/io/gltf/gltfjson.h"

#include <cmath>

namespace autocuts {

const Json &member(const Json &object, const char *key)
{
    static const Json null;
    if (!object.is_object())
        return null;
    const auto found = object.find(key);
    return found == object.end() ? null : *found;
}

const Json &element(const Json &root, const char *array, std::size_t index)
{
    const Json &elements = member(root, array);
    if (!elements.is_array() || index >= elements.size())
        throw GltfError("it refers to number " + std::to_string(index) + " of \"" + array +
                        "\", which is not there");
    return elements[index];
}

std::optional<std::size_t> wholeNumber(const Json &object, const char *key)
{
    const Json &value = member(object, key);
    if (value.is_null())
        return {};
    if (value.is_number_unsigned())
        return value.get<std::size_t>();
    // Some programs write 1.0 for 1. All whole numbers up to 2^53 are doubles.
    if (value.is_number()) {
        const double number = value.get<double>();
        if (number >= 0 && number < 0x1p53 && number == std::floor(number))
            return static_cast<std::size_t>(number);
    }
    throw GltfError(std::string("\"") + key + "\" is not a whole number");
}

std::size_t requiredNumber(const Json &object, const char *key)
{
    const std::optional<std::size_t> value = wholeNumber(object, key);
    if (!value)
        throw GltfError(std::string("\"") + key + "\" is missing");
    return *value;
}

std::string textOf(const Json &object, const char *key)
{
    const Json &value = member(object, key);
    return value.is_string() ? value.get<std::string>() : std::string();
}

std::string nameOr(const Json &object, const char *kind, std::size_t index)
{
    const std::string name = textOf(object, "name");
    return name.empty() ? std::string(kind) + ' ' + std::to_string(index + 1) : name;
}

} // namespace autocuts
