/* C17 7.2: diagnostics. May be included again with another NDEBUG. */
#undef assert

#ifdef NDEBUG
#define assert(expression) ((void)0)
#else
#define assert(expression) \
    ((expression) ? (void)0 : __crs_assert_failed(#expression, __FILE__, __LINE__, __func__))
#endif

#ifndef _ASSERT_H
#define _ASSERT_H
#ifndef static_assert
#define static_assert _Static_assert
#endif
void __crs_assert_failed(const char *expression, const char *file, int line, const char *function);
#endif
