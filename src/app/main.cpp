#include "app/LargePages.h"
#include "app/Program.h"

int main(int count, char** arguments) {
    walkcycle::useLargePages();
    return walkcycle::runProgram({arguments + 1, arguments + count});
}
