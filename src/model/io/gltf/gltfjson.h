// The JSON of a glTF file: reading values that may be missing or of a wrong type.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace autocuts {

//! Keeps the order of the keys, so that a rewritten file differs only where something was changed.
using Json = nlohmann::ordered_json;

//! What is wrong with a glTF file. Thrown inside this folder; readGltf() and writeGltf() turn it into an
//! Error.
struct GltfError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

//! The member of an object; a null value when it is missing or `object` is no object.
const Json &member(const Json &object, const char *key);

//! The element of an array that is a member of the root, for example of "accessors".
//! \throws GltfError when there is no such element
const Json &element(const Json &root, const char *array, std::size_t index);

//! A whole number that is not negative; nothing when the member is missing.
//! \throws GltfError when the member is anything else
std::optional<std::size_t> wholeNumber(const Json &object, const char *key);

//! As wholeNumber(), for members that must be there.
std::size_t requiredNumber(const Json &object, const char *key);

//! The text of a member; empty when it is missing or no text.
std::string textOf(const Json &object, const char *key);

//! The name of the element, or "KIND NUMBER", counted from 1, when it has none.
std::string nameOr(const Json &object, const char *kind, std::size_t index);

} // namespace autocuts
