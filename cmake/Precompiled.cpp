// Holds the precompiled headers (see WalkcycleTarget.cmake); there is nothing to compile.
