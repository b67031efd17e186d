#include "views/ui/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

//! Needed because the resources are in a static library, where the linker would drop them. Must be outside of
//! any namespace.
static void initTranslations()
{
    Q_INIT_RESOURCE(translations);
}

namespace autocuts {

namespace {

const QString ownFolder = QStringLiteral(":/translations");

void install(QCoreApplication &application, const QString &file, const QStringList &folders)
{
    auto *const translator = new QTranslator(&application);
    for (const QString &folder : folders) {
        if (translator->load(file, folder)) {
            QCoreApplication::installTranslator(translator);
            return;
        }
    }
    delete translator;
}

} // namespace

Language effectiveLanguage(Language chosen, const QStringList &systemLanguages)
{
    if (chosen != Language::System)
        return chosen;
    // Not QTranslator's own search: English needs no file, so that would go on to the next language.
    for (const QString &name : systemLanguages) {
        switch (QLocale(name).language()) {
        case QLocale::English:
            return Language::English;
        case QLocale::German:
            return Language::German;
        default:
            break;
        }
    }
    return Language::English;
}

void installLanguage(QCoreApplication &application, Language language)
{
    initTranslations();
    if (effectiveLanguage(language, QLocale::system().uiLanguages()) != Language::German) {
        install(application, QStringLiteral("autocuts_en"), {ownFolder}); // for texts with a number of one
        return;
    }
    install(application, QStringLiteral("qtbase_de"),
            {QLibraryInfo::path(QLibraryInfo::TranslationsPath), ownFolder});
    install(application, QStringLiteral("autocuts_de"), {ownFolder});
}

} // namespace autocuts
