/* Failed assertions (C17 7.2.1.1). */
#include <assert.h>
#include <crs_request.h>
#include <stdio.h>

#include <crs/stream.h>

void __crs_assert_failed(const char *expression, const char *file, int line, const char *function)
{
    __crs_flush_all();
    fprintf(stderr, "%s:%d: %s: Assertion `%s' failed.\n", file, line, function, expression);
    __crs_stop("assertion failed");
}
