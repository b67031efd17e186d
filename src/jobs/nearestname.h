// Finds the known name that is most similar to a misspelt one.
#pragma once

#include <QStringList>

namespace autocuts {

//! The name that a word becomes by the fewest changed, missing, added or exchanged letters; empty where that
//! is more than a third of it.
QString nearestName(const QString &word, const QStringList &names);

//! " (did you mean NAME?)" for messages; empty when no name is near.
QString didYouMean(const QString &word, const QStringList &names);

} // namespace autocuts
