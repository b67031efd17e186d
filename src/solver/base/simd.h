// Compiles a function for several generations of processors.
#pragma once

//! Placed before a function: compiles it for several generations of x86-64 processors; the best one for the
//! present processor is chosen when the program starts. All give the same bits, because multiplications and
//! additions are not fused. With other compilers and processors, and under sanitizers (which cannot run
//! before that choice), the function is compiled once.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(AUTOCUTS_SANITIZED)
#define AUTOCUTS_CLONES __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define AUTOCUTS_CLONES
#endif
