// The model with a picture on it, as a renderer would show it.
#pragma once

#include "views/canvas/toolmanager.h"
#include "views/control/jobrunner.h"
#include "views/control/studiocontext.h"
#include "views/state/viewstate.h"

#include <QDialog>
#include <QTemporaryDir>

class QCheckBox;
class QComboBox;
class QLabel;

namespace autocuts {

class MeshView;
class Questions;

//! Shows the map at work: a checkerboard of true texels, a texture resampled to a size, or the picture of the
//! layout, on a view of the model of its own. Changes nothing; the picture of the view can be saved.
class PreviewDialog final : public QDialog
{
    Q_OBJECT

public:
    enum class Picture { Checkerboard, Texture, Layout };

    PreviewDialog(const StudioContext &context, Questions &questions);
    ~PreviewDialog() override;

    MeshView &view() { return *mView; }
    //! What the view shows.
    const ViewOptions &options() const { return mState.options(); }
    //! False while the picture is being made.
    bool isReady() const { return !mJobs.isBusy(); }

private:
    QWidget *makeControls();
    void choosePicture();
    void browse();
    //! Makes the picture for what is chosen and shows it.
    void refresh();
    void showTexture(const QString &path);
    void save();
    Picture picture() const;
    int size() const;

    StudioContext mContext;
    Questions &mQuestions;
    QTemporaryDir mFolder; //!< of the resampled pictures
    QString mTexturePath;  //!< as the user chose it
    ViewState mState;
    StudioContext mViewContext; //!< with a view state of its own
    ToolManager mTools;         //!< none: the preview is only looked at
    JobRunner mJobs{JobRunner::OnCancel::LetGo};
    MeshView *mView;
    QComboBox *mPicture, *mSize;
    QCheckBox *mSeams;
    QLabel *mRemark;
};

} // namespace autocuts
