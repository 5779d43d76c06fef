/* POSIX grp.h: the robot's computer has one group. */
#ifndef _GRP_H
#define _GRP_H

#include <sys/types.h>

struct group {
    char *gr_name, *gr_passwd;
    gid_t gr_gid;
    char **gr_mem;
};

struct group *getgrgid(gid_t group);
struct group *getgrnam(const char *name);

#endif
