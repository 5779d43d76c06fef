/* The one user of a robot's computer, and the computer's name (POSIX pwd.h, sys/utsname.h). */
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
