// The engine works without Qt: a program that links nothing else unwraps a cube, and has no library of Qt
// loaded.
#include <QProcess>
#include <QTest>

class TestEngine : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void unwrapsWithoutQt()
    {
        QProcess program;
        program.start(QStringLiteral(ENGINE_ONLY), QStringList());
        QVERIFY(program.waitForFinished(60'000));
        const QString said = QString::fromUtf8(program.readAllStandardOutput());
        QVERIFY2(program.exitStatus() == QProcess::NormalExit && program.exitCode() == 0, qPrintable(said));
        QVERIFY(said.contains(QStringLiteral("libcholmod")) && said.contains(QStringLiteral("libembree")));
        QVERIFY2(!said.contains(QStringLiteral("libQt")), qPrintable(said));
    }
};

QTEST_GUILESS_MAIN(TestEngine)
#include "tst_engine.moc"
