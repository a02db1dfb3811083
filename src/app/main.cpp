#include "app/Program.h"

int main(int count, char** arguments) {
    return walkcycle::runProgram({arguments + 1, arguments + count});
}
