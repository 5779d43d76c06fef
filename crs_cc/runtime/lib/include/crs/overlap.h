/* Copies between overlapping objects have no defined result (C17 7.24.2); the library only. */
#ifndef CRS_OVERLAP_H
#define CRS_OVERLAP_H

#include <crs_request.h>

/* Stops the program when two ranges of some bytes overlap. */
#define CRS_KEEP_APART(to, from, size) \
    do { \
        if ((unsigned int)(to) - (unsigned int)(from) < (unsigned int)(size) || \
            (unsigned int)(from) - (unsigned int)(to) < (unsigned int)(size)) \
            __crs_stop("overlapping copy", to); \
    } while (0)

#endif
