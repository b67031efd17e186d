// The preview of the model with a texture.
#pragma once

#include "views/canvas/toolmanager.h"
#include "views/control/session/jobrunner.h"
#include "views/control/session/studiocontext.h"
#include "views/state/viewstate.h"

#include <QDialog>
#include <QTemporaryDir>

class QCheckBox;
class QComboBox;
class QLabel;

namespace autocuts {

class MeshView;
class Questions;

//! Shows a checkerboard with squares of a fixed number of texels, a texture resampled to a size, or the
//! picture of the layout, in its own 3D view. Changes nothing; the view can be saved as a picture.
class PreviewDialog final : public QDialog
{
    Q_OBJECT

public:
    enum class Picture { Checkerboard, Texture, Layout };

    PreviewDialog(const StudioContext &context, Questions &questions);
    ~PreviewDialog() override;

    MeshView &view() { return *mView; }
    //! The options of the view.
    const ViewOptions &options() const { return mState.options(); }
    //! False while the texture is being made.
    bool isReady() const { return !mJobs.isBusy(); }

private:
    QWidget *makeControls();
    void choosePicture();
    void browse();
    //! Makes the texture for the current choice and shows it.
    void refresh();
    void showTexture(const QString &path);
    void save();
    Picture picture() const;
    int size() const;

    StudioContext mContext;
    Questions &mQuestions;
    QTemporaryDir mFolder; //!< contains the resampled textures
    QString mTexturePath;  //!< the texture that the user chose
    ViewState mState;
    StudioContext mViewContext; //!< has its own view state
    ToolManager mTools;         //!< empty: the preview has no tools
    JobRunner mJobs{JobRunner::OnCancel::LetGo};
    MeshView *mView;
    QComboBox *mPicture, *mSize;
    QCheckBox *mSeams;
    QLabel *mRemark;
};

} // namespace autocuts
