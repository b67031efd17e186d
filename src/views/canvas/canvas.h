// The common part of both views: drawing, picking, navigation and passing events to the tool.
#pragma once

#include "views/canvas/madepictures.h"
#include "views/canvas/navigation.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/ui/task.h"

#include <QCborMap>
#include <QImage>
#include <QTimer>

#include <memory>

class QPainter;

namespace autocuts {

struct Environment;

class ToolManager;
struct GlResources;
struct ToolEvent;

//! Base class of MeshView and UvView.
class Canvas : public ToolCanvas
{
    Q_OBJECT

public:
    ~Canvas() override;

    const SceneContent &content() const override { return mContent; }

    virtual void frameAll() = 0;
    //! Frames the selection, or everything when nothing is selected.
    virtual void frameSelection() = 0;
    //! The state of the camera, for the session file.
    virtual QCborMap viewState() const = 0;
    //! Restores the camera; missing or invalid values are left unchanged.
    virtual void restoreViewState(const QCborMap &state) = 0;
    //! A picture of the view.
    QImage picture() { return grabFramebuffer(); }
    //! A widget that lies over the bottom of the view whenever it is visible. Legends stay above it. Not
    //! owned.
    void setCover(const QWidget *cover) { mCover = cover; }

Q_SIGNALS:
    //! The user wants the menu for what is at a pixel: by a right click that no gesture of navigation or of
    //! the tool uses, or by the key for menus.
    void menuRequested(const QPointF &pixel);

protected:
    Canvas(Kind kind, const StudioContext &context, ToolManager &tools, QWidget *parent);

    //! Draws everything except the overlay. The buffers are up to date, and the view has not been cleared.
    virtual void drawScene(GlResources &gl) = 0;
    //! Shows everything except the overlay of what is drawn a little at a time; false: this view does not.
    virtual bool showGradually(GlResources &) { return false; }
    virtual void drawOverlay(QPainter &painter) = 0;
    //! The part of the view above its cover.
    QRect uncovered() const;
    //! Fills the buffers with what has changed. In a paint of a large mesh those for the arrays stay as they
    //! are: workOn() fills them.
    void upload();
    //! Works for the next picture between two paints: updates one array of a large mesh.
    virtual void workOn();
    void workSoon() { mWorkSoon.start(); }
    //! True when arrays of a large mesh are to be updated before a picture begins that is drawn gradually.
    bool arraysComeFirst() const { return mContent.isLarge() && !mContent.isUpToDate() && !mArraysAreNew; }
    void pictureBegins() { mArraysAreNew = false; }
    //! Grows with every change of what drawScene() draws but that of the camera.
    quint64 revision() const { return mRevision; }
    //! Null when there is nothing to draw with.
    GlResources *resources() { return mGl.get(); }
    //! \param pixels distance that the mouse moved
    virtual void navigate(Navigation navigation, const QPointF &pixels, const QPointF &start) = 0;
    virtual void zoomAt(double factor, const QPointF &pixel) = 0;
    //! The mouse is over something that is drawn over the view and takes clicks. \param pressed the left
    //! button went down there
    virtual bool overlayTakes(const QPointF & /*pixel*/, bool /*pressed*/) { return false; }
    virtual void viewResized() = 0;
    virtual void documentReplaced() = 0;

    //! The soup corners of all selected elements, in ascending order.
    std::vector<int> selectedSoupCorners() const;
    //! Which set of pictures all triangles have, from 1; 0: that of their materials.
    int onlySet() const;
    //! The triangles and sides under the mouse, in either view.
    struct HoverParts
    {
        std::array<int, 2> triangles{0, 0}, sides{-1, -1};
        unsigned island = 0;
    };
    HoverParts hoverParts() const;

    void initializeGL() override;
    void paintEvent(QPaintEvent *event) override;
    void paintGL() override;
    void resizeGL(int width, int height) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;
    bool event(QEvent *event) override;

private:
    void releaseGl();
    void takeTurn();
    bool isTurnOfOthers() const;
    void uploadArrays(int parts);
    void changePicture();
    void choosePicture();
    const Pictures &wantedPictures() const;
    void uploadPictures();
    void uploadOn();
    void uploadForLight();
    void makeTangents();
    void updateCursor();
    void placeCursor(const QPointF &pixel);
    void endLostGestures(Qt::MouseButtons held);
    ToolEvent toolEvent(const QMouseEvent &event, bool withPick);

    ToolManager &mTools;
    const QWidget *mCover = nullptr;
    quint64 mRevision = 1;
    bool mPainting = false; //!< for the window, not for a picture
    bool mResizing = false; //!< the base class paints at once, before the window does
    SceneContent mContent;
    bool mArraysAreNew = false; //!< no picture has been begun with those that workOn() updated last
    MadePictures mTexture, mLetters;
    bool mTextureStale = true;
    bool mTangentsStale = true;
    Task mTangents;                                  //!< being made
    std::shared_ptr<const Environment> mEnvironment; //!< in graphics memory
    Pattern mPictured = Pattern::None;               //!< of the pictures that are wanted
    Pattern mUploaded = Pattern::None;               //!< of those that were uploaded last
    QTimer mWorkSoon;                                //!< takes the next turn
    QTimer mUploadSoon;                              //!< goes on with the upload of pictures
    std::unique_ptr<GlResources> mGl; //!< null before the first paint, and when OpenGL is not available
    QString mGlError;                 //!< why OpenGL is not available
    QMetaObject::Connection mContextGone;
    Navigation mNavigation = Navigation::None;
    Qt::MouseButton mNavigationButton = Qt::NoButton;
    QPointF mLastMouse, mNavigationStart;
    bool mToolPressed = false;
    std::optional<QPointF> mMenuPress; //!< where the right button went down for a menu
};

} // namespace autocuts
