/* The one user of a robot's computer, and the computer's name (POSIX pwd.h, grp.h,
   sys/utsname.h). */
#include <grp.h>
#include <pwd.h>
#include <string.h>
#include <sys/utsname.h>

static struct passwd user = {"robot", "x", 0, 0, "robot", "/", "/bin/sh"};

struct passwd *getpwuid(uid_t number)
{
    return number == 0 ? &user : 0;
}

struct passwd *getpwnam(const char *name)
{
    return strcmp(name, user.pw_name) == 0 ? &user : 0;
}

int uname(struct utsname *name)
{
    strcpy(name->sysname, "crs");
    strcpy(name->nodename, "robot");
    strcpy(name->release, "1");
    strcpy(name->version, "1");
    strcpy(name->machine, "i386");
    return 0;
}

static char *members[] = {"robot", 0};
static struct group group = {"robot", "x", 0, members};

struct group *getgrgid(gid_t number)
{
    return number == 0 ? &group : 0;
}

struct group *getgrnam(const char *name)
{
    return strcmp(name, group.gr_name) == 0 ? &group : 0;
}
