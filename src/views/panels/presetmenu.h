// The menu of presets: settings under a name, the same files as on the command line.
#pragma once

#include "jobs/mapsettings.h"
#include "views/control/session/studiocontext.h"
#include "views/ui/task.h"

#include <QMenu>
#include <QStringList>

#include <functional>

namespace autocuts {

class Questions;

//! Offers the presets of the program and those of the user, saves the settings of the session as one, and
//! deletes those of the user. Files are read and written on another thread.
class PresetMenu final : public QMenu
{
    Q_OBJECT

public:
    PresetMenu(const StudioContext &context, Questions &questions, QWidget *parent = nullptr);

Q_SIGNALS:
    //! The settings of a preset are those of the session. \param message translated, one line
    void applied(const QString &message);
    //! The presets that there are have been listed.
    void listed();

private:
    struct Names
    {
        QStringList all, own;
        bool operator==(const Names &) const = default;
    };

    //! Lists anew what there is.
    void list();
    //! Works on another thread, then lists anew.
    void change(const std::function<Result<Done>()> &work);
    void afterwardsList(Task &task, const std::function<Result<Done>()> &work);
    void showProblem(const QString &message);
    void fill(const Names &names);
    void choose(const QString &name);
    void apply(const QString &name, const Result<Preset> &preset);
    void askAndSave();
    void askAndRemove(const QString &name);
    jobs::MapSettings settings() const;

    StudioContext mContext;
    Questions &mQuestions;
    Names mNames;
    QMenu *mRemove = nullptr;
    Task mListing, mChanging, mReading;
};

} // namespace autocuts
