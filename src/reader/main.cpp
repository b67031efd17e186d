// autocuts-reader: reads a mesh file by Assimp for the other programs and writes the scene to its standard
// output. A file that crashes or hangs Assimp, or takes all memory, ends this program only.
#include "model/io/assimp/assimpimport.h"
#include "model/io/assimp/assimpstream.h"
#include "reader/process.h"

#include <cstdio>
#include <cstdlib>
#include <new>

namespace {

[[noreturn]] void endForLackOfMemory()
{
    autocuts::endWith(autocuts::readerexit::outOfMemory);
}

} // namespace

//! Arguments: the file, the limits of memory in bytes and of processor time in seconds.
int main(int argc, char *argv[])
{
    if (argc != 4) {
        std::fputs("autocuts-reader is started by autocuts and autocuts-cli\n", stderr);
        return 2;
    }
    autocuts::endWithParent();
    autocuts::setLimits(std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10));
    std::set_new_handler(endForLackOfMemory);
    std::FILE *out = autocuts::takeOutput();
    if (!out)
        return autocuts::readerexit::outOfMemory;
    autocuts::importWithAssimp(argv[1], out, autocuts::endWith);
    return autocuts::readerexit::unreadable;
}
