// The parts of a session besides the model: UV sets, steering, settings, selection and view.
#pragma once

#include "model/document/documentstate.h"

#include <QCborMap>
#include <QStringList>

#include <map>
#include <optional>

namespace autocuts {

//! Contents of blocks by name.
using PartMap = std::map<QByteArray, QByteArray>;

//! What of a state goes into its parts.
enum class StateScope {
    Session, //!< everything but the scene's static part
    Journal  //!< the same without selection and view state
};

PartMap statePartsOf(const DocumentState &state, StateScope scope);

//! What was not whole, as the words that a message needs: "the seams", "UV set 2", ...
struct LostParts
{
    QStringList names;
    int seams = 0; //!< seams that do not fit the mesh
};

//! Fills everything in the state but the scene's static part. What is missing or damaged in the parts gets
//! its default and is listed. \pre state.scene has its mesh
LostParts readStateParts(const PartMap &parts, StateScope scope, DocumentState &state);

//! A CBOR map from untrusted bytes; nothing when they are damaged or something else.
std::optional<QCborMap> parsedMap(const QByteArray &bytes);

} // namespace autocuts
