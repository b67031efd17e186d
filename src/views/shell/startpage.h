// What is shown instead of the views while nothing is open.
#pragma once

#include "views/control/session/jobrunner.h"
#include "views/control/session/studiocontext.h"

#include <QWidget>

class QLabel;
class QListWidget;

namespace autocuts {

//! Offers to open a file, the samples, and the recent files with their folders and thumbnails. Covers its
//! parent while no document is open.
class StartPage final : public QWidget
{
    Q_OBJECT

public:
    StartPage(const StudioContext &context, QWidget *parent);

Q_SIGNALS:
    //! A recent file was chosen.
    void openRequested(const QString &path);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *makeOpening();
    QWidget *makeRecent();
    void showOrHide();
    void showRecent();

    StudioContext mContext;
    QLabel *mRecentTitle;
    QListWidget *mRecent;
    JobRunner mReading{JobRunner::OnCancel::LetGo}; //!< reads the thumbnails
};

} // namespace autocuts
