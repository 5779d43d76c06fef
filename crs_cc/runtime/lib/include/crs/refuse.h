/* Functions that a sandbox cannot offer: they link, report it once on standard error, and
   return their error value with errno. */
#ifndef CRS_REFUSE_H
#define CRS_REFUSE_H

/* Says once that a function is not available, and sets errno. */
void __crs_refuse(int *said, const char *function, int number);

/* Defines such a function: UNAVAILABLE(int, fork, (void), -1, ENOSYS) */
#define UNAVAILABLE(type, name, parameters, result, number)   \
    type name parameters                                      \
    {                                                         \
        static int said;                                      \
                                                              \
        __crs_refuse(&said, #name, number);                   \
        return result;                                        \
    }

#endif
