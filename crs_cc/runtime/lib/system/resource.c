/* Processor time and limits (POSIX sys/resource.h). */
#include <sys/resource.h>

#include <crs/clock.h>

int getrusage(int who, struct rusage *used)
{
    double processor_s;
    long long microseconds;

    __builtin_memset(used, 0, sizeof *used);
    if (who != RUSAGE_SELF)
        return 0;
    __crs_now(&processor_s);
    microseconds = (long long)(processor_s * 1e6 + 1e-3);
    used->ru_utime.tv_sec = microseconds / 1000000;
    used->ru_utime.tv_usec = microseconds % 1000000;
    return 0;
}

/* The limits are those of the simulator. */
int getrlimit(int which, struct rlimit *limit)
{
    limit->rlim_cur = limit->rlim_max = which == RLIMIT_NOFILE ? 64 : RLIM_INFINITY;
    return 0;
}

int setrlimit(int which, const struct rlimit *limit)
{
    (void)which;
    (void)limit;
    return 0;
}

int getpriority(int which, id_t who)
{
    (void)which;
    (void)who;
    return 0;
}

int setpriority(int which, id_t who, int priority)
{
    (void)which;
    (void)who;
    (void)priority;
    return 0;
}
