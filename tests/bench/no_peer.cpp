// A shared library that offers nothing to the micro benchmark.
extern "C" int tribunal_of_no_use(void);
extern "C" int tribunal_of_no_use(void) { return 0; }
