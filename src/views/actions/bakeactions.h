// The actions that bake and carry textures over.
#pragma once

#include "jobs/bakechoice.h"
#include "jobs/carrychoice.h"
#include "jobs/lightchoice.h"
#include "views/control/jobs/picturecontroller.h"
#include "views/control/session/studiocontext.h"
#include "views/state/viewstate.h"

#include <QDateTime>
#include <QHash>
#include <QObject>

namespace autocuts {

class Document;
class Questions;

//! Asks what is to be baked or carried over, and starts the job.
class BakeActions final : public QObject
{
    Q_OBJECT

public:
    BakeActions(const StudioContext &context, Questions &questions, QObject *parent = nullptr);

    //! What was chosen last for a bake, for the session.
    const jobs::BakeChoice &choice() const { return mChoice; }
    void setChoice(const jobs::BakeChoice &choice) { mChoice = choice; }
    //! The lights that were chosen for this document; null before.
    const jobs::LightChoice *light() const { return mHasLight ? &mLight : nullptr; }
    void setLight(const jobs::LightChoice &light);

    PictureController &pictures() { return mPictures; }

private:
    void ask(const Document &document);
    void showLive();
    void askCarrying(const Document &document);
    void askLight(const Document &document);
    void noteBaked();
    void show(Pattern pattern);

    StudioContext mContext;
    Questions &mQuestions;
    PictureController mPictures;
    jobs::BakeChoice mChoice; //!< the one last made
    QStringList mBaking;      //!< files of the bake that runs
    //! The files of earlier bakes and when they were written. Those that were not changed since are replaced
    //! without a question.
    QHash<QString, QDateTime> mBaked;
    jobs::CarryChoice mCarryChoice; //!< likewise, without what belongs to a model
    jobs::LightChoice mLight;       //!< likewise, for this document
    bool mHasLight = false;
};

} // namespace autocuts
