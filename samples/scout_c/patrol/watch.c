/*
 * watch.c - the time since the patrol began.
 */

# include <time.h>
# include "patrol.h"

static time_t began;

start_watch()
{
    time(&began);
}

tick()
{
    time_t now;

    time(&now);
    minutes = (now - began) / 60;
    seconds = (now - began) % 60;
}
