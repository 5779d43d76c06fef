/* The ultra-wideband radio for C programs: crs_uwb() of crs.h, and a wait on top of it. */
#ifndef CRS_UWB_H
#define CRS_UWB_H

#include <crs.h>
#include <unistd.h>

/* Waits until another robot is nearer than this distance [0.1 inch], and returns how near it is. */
static inline int uwb_wait_nearer(int distance)
{
    int now;

    while (!crs_uwb(&now) || now >= distance)
        usleep(100000);
    return now;
}

#endif
