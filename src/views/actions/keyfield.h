// A field that records a shortcut.
#pragma once

#include <QKeySequence>
#include <QLineEdit>

namespace autocuts {

//! Shows shortcuts. A click makes it record the next key with its modifiers. Escape, or a click elsewhere,
//! stops recording without a change.
class KeyField final : public QLineEdit
{
    Q_OBJECT

public:
    explicit KeyField(QWidget *parent = nullptr);

    void setKeys(const QString &text);
    bool isRecording() const { return mRecording; }
    void startRecording();

Q_SIGNALS:
    void recorded(const QKeySequence &keys);

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void stopRecording();

    QString mKeys; //!< shown while not recording
    bool mRecording = false;
};

} // namespace autocuts
