// What a map is like, in one line, and what to do next.
#pragma once

#include "views/control/jobs/mapcontroller.h"

#include <QString>

namespace autocuts {

class Document;

//! One line for the user, and the id of the action that comes next; empty without one.
struct MapOutcome
{
    QString text;
    const char *nextAction = "";
};

//! \param figures of the document's map \param bound on the distortion D
MapOutcome outcomeOf(const Document &document, const MapFigures &figures, double bound);

} // namespace autocuts
