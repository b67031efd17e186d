// One or more cases for every command, with the texts and events that are expected.
#pragma once

#include "commands/changesettings.h"
#include "commands/editpins.h"
#include "commands/editrectangles.h"
#include "commands/setislandflags.h"
#include "commands/setseamstate.h"
#include "commands/setuvs.h"

#include <QStringList>

#include <functional>
#include <memory>
#include <vector>

namespace autocuts::test {

using CommandPtr = std::unique_ptr<DocumentCommand>;
using Make = std::function<CommandPtr(Document &)>;

//! One command to try on gridDocument().
struct Case
{
    const char *name;
    Make make;
    const char *text;   //!< without translations, so with "1 edges"
    QStringList events; //!< of doing it
    Make noop;          //!< the same kind of command, changing nothing on gridDocument() (null: cannot be)
};

//! All cases.
const std::vector<Case> &commandCases();
//! gridDocument() with something for every command to change.
std::unique_ptr<Document> startFor(const Case &c);

// Makers of commands.
std::vector<int> plainEdges(const Document &document, int first, int count);
Make seams(SetSeamState::Edit edit, int first, int count);
Make straight(bool on, int first, int count);
Make paint(int firstPair, int count, double weight);
Make rectangle(EditRectangles::Edit edit, int id, std::function<void(LayoutRectangle &)> change);
LayoutRectangle named(const QString &name);
Make pins(EditPins::Edit edit, std::vector<UvPin> values);
Make uvs(UvEdit edit, int corner, double u, UvEditExtras extras = {});
Make transform(UvEdit edit, Eigen::Affine2d by, std::vector<int> islands);
Make solve(std::function<void(SolveSettings &)> change);
Make packing(std::function<void(PackingSettings &)> change);
Make flags(SetIslandFlags::Edit edit, std::vector<int> islands);
Make tag(QString name, std::vector<int> islands, bool on);
Make texelWeights(int firstFace, int count, double weight);
Make hide(QList<int> faces);
Make textures(const QString &file);
Make reset(int parts);
Eigen::Affine2d moved(double u, double v);

} // namespace autocuts::test
