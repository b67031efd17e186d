// The nodes of FBX files: read, changed one by one, and all other bytes kept.
#include "model/io/fbx/fbxeditor.h"
#include "model/io/fbx/fbxparsing.h"
#include "support/fbxfiles.h"

#include <QTest>

#include <cmath>

namespace tst_fbxtree {

using namespace autocuts;
using fbxfiles::Kind;
using fbxfiles::Node;

namespace {

const std::vector<Node> sampleNodes{
    {"Empty", {}, {}, true},
    {"Values",
     {true, std::int16_t(-3), std::int32_t(-70000), std::int64_t(5'000'000'000), -0.25, QByteArray("text")},
     {}},
    {"Outer",
     {std::int32_t(7)},
     {{"Doubles", {std::vector<double>{0.1, -2, 1e300}}, {}},
      {"Integers", {std::vector<std::int32_t>{3, -1, 2'000'000'000}}, {}},
      {"Longs", {std::vector<std::int64_t>{5'000'000'000, 4}}, {}},
      {"Floats", {std::vector<float>{0.5F, 3}}, {}},
      {"Many", {std::vector<double>(1000, 0.125)}, {}},
      {"Inner", {}, {{"Leaf", {QByteArray("first")}, {}}, {"Leaf", {QByteArray("second")}, {}}}}}},
    {"Last", {std::int32_t(1)}, {}},
};

FbxTree parsed(const QByteArray &bytes)
{
    Result<FbxTree> tree = parseFbxTree(bytes, QStringLiteral("a.fbx"));
    if (!tree)
        qFatal("%s", qPrintable(tree.error().toString()));
    return std::move(tree).value();
}

//! Every node as its path and the bytes of its values.
QByteArrayList contents(const FbxTree &tree)
{
    QByteArrayList list;
    std::vector<QByteArray> paths(tree.nodes.size());
    for (std::size_t n = 1; n < tree.nodes.size(); ++n) {
        const FbxNode &node = tree.nodes[n];
        const std::string_view name = tree.name(static_cast<int>(n));
        paths[n] =
            paths[static_cast<std::size_t>(node.parent)] + '/' + QByteArray(name.data(), std::ssize(name));
        list << paths[n] + ' ' +
                    tree.bytes.sliced(node.valuesBegin, node.valuesEnd - node.valuesBegin).simplified();
    }
    return list;
}

void addKinds()
{
    QTest::addColumn<Kind>("kind");
    QTest::newRow("binary 6100") << Kind{true, 6100};
    QTest::newRow("binary 7100 big-endian") << Kind{true, 7100, true};
    QTest::newRow("binary 7400") << Kind{true, 7400};
    QTest::newRow("binary 7400, arrays not packed") << Kind{true, 7400, false, false};
    QTest::newRow("binary 7500") << Kind{true, 7500};
    QTest::newRow("binary 7700 big-endian") << Kind{true, 7700, true};
    QTest::newRow("text 6100") << Kind{false, 6100};
    QTest::newRow("text 7400, CR LF") << Kind{false, 7400, false, true, "\r\n"};
    QTest::newRow("text 7700") << Kind{false, 7700};
}

} // namespace

class TestFbxTree : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void values_data() { addKinds(); }
    void values();
    void changes_data() { addKinds(); }
    void changes();
    void insertedAndRemovedIsTheSame_data() { addKinds(); }
    void insertedAndRemovedIsTheSame();
    void textForms();
    void badInput_data();
    void badInput();
    void arraysHaveALimit();
    void stops();
};

void TestFbxTree::values()
{
    QFETCH(Kind, kind);
    const FbxTree tree = parsed(fbxfiles::file(kind, sampleNodes));
    QCOMPARE(tree.version, kind.version);
    QCOMPARE(FbxEditor(tree).result(), tree.bytes);
    QVERIFY(tree.nodes[static_cast<std::size_t>(tree.child(0, "Empty"))].listEnd > 0);
    const std::vector<FbxValue> values = tree.values(tree.child(0, "Values"));
    QCOMPARE(values.size(), std::size_t(6));
    QCOMPARE(values[1].integer, -3);
    QCOMPARE(values[2].integer, -70000);
    QCOMPARE(values[3].integer, 5'000'000'000);
    QCOMPARE(values[4].number, -0.25);
    QCOMPARE(values[5].text, std::string_view("text"));
    const int outer = tree.child(0, "Outer");
    QCOMPARE(tree.integer(outer).value_or(0), 7);
    const auto doubles = [&](const char *name) { return tree.doubles(tree.child(outer, name)).value(); };
    QCOMPARE(doubles("Doubles"), (std::vector<double>{0.1, -2, 1e300}));
    QCOMPARE(doubles("Longs"), (std::vector<double>{5e9, 4}));
    QCOMPARE(doubles("Floats"), (std::vector<double>{0.5, 3}));
    QCOMPARE(doubles("Many"), std::vector<double>(1000, 0.125));
    QCOMPARE(tree.integers(tree.child(outer, "Integers")).value(), (std::vector<int>{3, -1, 2'000'000'000}));
    QCOMPARE(tree.integers(tree.child(outer, "Longs")).value(), (std::vector<int>{-1, 4}));
    const int leaf = tree.child(tree.child(outer, "Inner"), "Leaf");
    QCOMPARE(tree.text(leaf), std::string_view("first"));
    QCOMPARE(tree.text(tree.nextNamed(leaf)), std::string_view("second"));
}

void TestFbxTree::changes()
{
    QFETCH(Kind, kind);
    const FbxTree tree = parsed(fbxfiles::file(kind, sampleNodes));
    const int outer = tree.child(0, "Outer");
    const int inner = tree.child(outer, "Inner");
    FbxEditor editor(tree);
    const std::vector<double> numbers{0.1, -1.0 / 3, 5};
    editor.replace(tree.child(outer, "Doubles"), {"Doubles", {numbers}, {}, false});
    editor.remove(tree.child(outer, "Integers"));
    editor.insertAfter(tree.child(outer, "Floats"), {"New", {std::vector<int>(50, 8)}, {}, false});
    editor.append(inner, {"Leaf", {QByteArray("third \"quoted\"")}, {}, false});
    editor.append(tree.child(0, "Empty"), {"Filled", {}, {{"Deep", {1}, {}, false}}, true});
    editor.setInteger(tree.child(0, "Last"), 12);
    const FbxTree changed = parsed(editor.result());

    const int outerNow = changed.child(0, "Outer");
    QCOMPARE(changed.doubles(changed.child(outerNow, "Doubles")).value(), numbers);
    QCOMPARE(changed.child(outerNow, "Integers"), -1);
    QCOMPARE(changed.integers(changed.child(outerNow, "New")).value(), std::vector<int>(50, 8));
    QCOMPARE(changed.integer(changed.child(0, "Last")).value_or(0), 12);
    const std::string_view deep[] = {"Empty", "Filled", "Deep"};
    QCOMPARE(changed.integer(changed.find(deep)).value_or(0), 1);
    int leaf = changed.child(changed.child(outerNow, "Inner"), "Leaf");
    leaf = changed.nextNamed(changed.nextNamed(leaf));
    const std::string_view third = changed.text(leaf);
    QCOMPARE(kind.binary ? QByteArray(third.data(), std::ssize(third)) : unescapedFbx(third),
             QByteArray("third \"quoted\""));
    // All others as they were.
    QByteArrayList before = contents(tree);
    QByteArrayList after = contents(changed);
    const auto drop = [](QByteArrayList &list, const char *part) {
        list.removeIf([part](const QByteArray &line) { return line.contains(part); });
    };
    for (const char *part : {"/Doubles", "/Integers", "/New", "third", "/Filled", "/Last"}) {
        drop(before, part);
        drop(after, part);
    }
    QCOMPARE(after, before);
    if (!kind.binary)
        return;
    // The footer is aligned.
    QCOMPARE(changed.bytes.size() % 16, tree.bytes.size() % 16);
    QCOMPARE(changed.bytes.last(140), tree.bytes.last(140));
}

void TestFbxTree::insertedAndRemovedIsTheSame()
{
    QFETCH(Kind, kind);
    const FbxTree tree = parsed(fbxfiles::file(kind, sampleNodes));
    const int inner = tree.child(tree.child(0, "Outer"), "Inner");
    FbxEditor editor(tree);
    editor.append(inner, {"Extra", {std::vector<double>(77, 0.3)}, {}, false});
    editor.insertAfter(tree.child(0, "Values"), {"Extra", {}, {{"Leaf", {2}, {}, false}}, true});
    const FbxTree more = parsed(editor.result());
    QVERIFY(more.bytes.size() > tree.bytes.size() + 20);
    FbxEditor back(more);
    back.remove(more.child(0, "Extra"));
    back.remove(more.child(more.child(more.child(0, "Outer"), "Inner"), "Extra"));
    QCOMPARE(back.result(), tree.bytes);
}

void TestFbxTree::textForms()
{
    const FbxTree tree =
        parsed("\xEF\xBB\xBF; FBX\nFBXHeaderExtension: { FBXVersion: 7400 }\n"
               "Content: , \n\t\"YWJj\",\n \"ZGVm\"\nList: 1,2 ; rest of a line , 9\n , 3,\n4\n"
               "Odd: nan, 1.#IND, -inf, +5, .5, 1e400\nNone:\nShading: W\nA: *0 {\n} B: *2 { a: 1,2\n}\n");
    QCOMPARE(tree.values(tree.child(0, "Content")).size(), std::size_t(2));
    QCOMPARE(tree.doubles(tree.child(0, "List")).value(), (std::vector<double>{1, 2, 3, 4}));
    const std::vector<double> odd = tree.doubles(tree.child(0, "Odd")).value();
    QCOMPARE(odd.size(), std::size_t(6));
    QVERIFY(std::isnan(odd[0]) && std::isnan(odd[1]) && std::isinf(odd[2]) && std::isinf(odd[5]));
    QCOMPARE(odd[3], 5.0);
    QCOMPARE(odd[4], 0.5);
    QVERIFY(tree.values(tree.child(0, "None")).empty());
    QCOMPARE(tree.text(tree.child(0, "Shading")), std::string_view("W"));
    QVERIFY(tree.doubles(tree.child(0, "A")).value().empty());
    QCOMPARE(tree.integers(tree.child(0, "B")).value(), (std::vector<int>{1, 2}));
    QCOMPARE(unescapedFbx("a&quot;&lf;&amp"), QByteArray("a\"\n&amp"));
}

void TestFbxTree::badInput_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("message");
    const auto row = [](const char *name, const QByteArray &bytes, int line, const char *message) {
        QTest::newRow(name) << bytes << line << QString::fromLatin1(message);
    };
    const QByteArray head = "FBXHeaderExtension: {\n FBXVersion: 7400\n}\n";
    row("empty", "", 0, "empty");
    row("another format", QByteArray("\x89PNG\0\1", 6), 0, "neither");
    row("prose", "this is no model\n", 1, "a name with a colon");
    row("no version", "A: 1\n", 0, "does not say its FBX version");
    row("too old", fbxfiles::file({true, 5800}, {}), 0, "version 5.8 are too old");
    row("too new", fbxfiles::file({false, 8000}, {}), 0, "version 8.0 are newer");
    row("open brace", head + "A: {\nB: {\n}\n", 7, "within the braces of \"A\"");
    row("brace too many", head + "}\n", 4, "a closing brace too many");
    row("open string", head + "A: \"x\n", 4, "quotation mark");
    row("deep text", head + QByteArray("a: {").repeated(100000), 4, "too deeply");
    const QByteArray good = fbxfiles::file({}, sampleNodes);
    row("header only", good.left(25), 0, "ends in its header");
    row("cut off", good.left(300), 0, "beyond its place");
    QByteArray far = good;
    far[27 + 3] = '\x7f';
    row("far end", far, 0, "beyond its place");
    std::vector<Node> deep{{"deep", {}, {}, true}};
    for (int i = 0; i < 70; ++i)
        deep = {{"deep", {}, deep}};
    row("deep binary", fbxfiles::file({}, deep), 0, "too deeply");
}

void TestFbxTree::badInput()
{
    QFETCH(QByteArray, bytes);
    QFETCH(int, line);
    QFETCH(QString, message);
    const Result<FbxTree> tree = parseFbxTree(bytes, QStringLiteral("a.fbx"));
    QVERIFY(!tree.ok());
    QVERIFY2(tree.error().message.contains(message), qPrintable(tree.error().message));
    QCOMPARE(tree.error().line, line);
    QCOMPARE(tree.error().file, QStringLiteral("a.fbx"));
    QVERIFY(!tree.error().remedy.isEmpty());
}

void TestFbxTree::arraysHaveALimit()
{
    // 64 MB of zeros in 64 kB, over and over.
    const std::vector<double> zeros(8'000'000, 0);
    const FbxTree tree = parsed(fbxfiles::file({}, {{"Zeros", {zeros}, {}}}));
    const int node = tree.child(0, "Zeros");
    int read = 0;
    while (read < 1000 && tree.doubles(node))
        ++read;
    QVERIFY(read >= 2);
    QVERIFY(read < 20);
    // A count beyond what the stream can hold.
    QByteArray forged = fbxfiles::file({}, {{"Few", {std::vector<double>(40, 0)}, {}}});
    const qsizetype at = forged.indexOf("Fewd") + 4;
    forged.replace(at, 4, QByteArray("\xff\xff\xff\x0f", 4));
    const FbxTree broken = parsed(forged);
    QVERIFY(!broken.doubles(broken.child(0, "Few")));
}

void TestFbxTree::stops()
{
    const std::atomic<bool> stop = true;
    for (const bool binary : {true, false})
        QVERIFY(
            !parseFbxTree(fbxfiles::file({binary, 7400}, sampleNodes), QStringLiteral("a.fbx"), &stop).ok());
}

QTEST_APPLESS_MAIN(TestFbxTree)

} // namespace tst_fbxtree

#include "tst_fbxtree.moc"
