// The blocks of a session besides the model: UV sets, steering, settings, selection and view.
#pragma once

#include "model/document/documentstate.h"

#include <QCborMap>
#include <QStringList>

#include <map>
#include <optional>

namespace autocuts {

//! Contents of the blocks by name.
using PartMap = std::map<QByteArray, QByteArray>;

//! Which parts of a state are stored.
enum class StateScope {
    Session, //!< everything except the unchanging part of the scene
    Journal  //!< the same, without selection and view state
};

PartMap statePartsOf(const DocumentState &state, StateScope scope);

//! What was damaged, in words for messages such as "the seams" or "UV set 2".
struct LostParts
{
    QStringList names;
    int seams = 0; //!< number of seams on edges that the mesh does not have
};

//! Reads everything in the state except the unchanging part of the scene. Missing or damaged values get their
//! defaults and are listed in the result. \pre state.scene has its mesh
LostParts readStateParts(const PartMap &parts, StateScope scope, DocumentState &state);

//! True when a block of this name holds a UV set.
bool isUvPart(const QByteArray &name);

//! Decodes untrusted bytes to a CBOR map; nothing when they are damaged or not a map.
std::optional<QCborMap> parsedMap(const QByteArray &bytes);

} // namespace autocuts
