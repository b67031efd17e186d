// The language of the texts.
#pragma once

#include "views/ui/preferences.h"

class QCoreApplication;

namespace autocuts {

//! Language::System becomes the first language of the system that there are texts in; English when there is
//! none.
Language effectiveLanguage(Language chosen, const QStringList &systemLanguages);

//! Makes tr() give the texts in a language: those of this program and Qt's own, which stay English where
//! neither Qt nor the build brought them. To be called once, before any text is read.
void installLanguage(QCoreApplication &application, Language language);

} // namespace autocuts
