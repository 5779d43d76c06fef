/* The environment (C17 7.22.4.6; setenv, putenv: POSIX). It is empty when a program begins. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

static char *nothing[1];
char **environ = nothing;

static int count;
static int capacity;    /* of `environ` when it is ours, in names without the final null; else 0 */

/* Returns the place of a name of `size` characters, or of the null pointer after all. */
static char **find(const char *name, size_t size)
{
    char **at = environ;

    for (; *at != NULL; at++)
        if (strncmp(*at, name, size) == 0 && (*at)[size] == '=')
            break;
    return at;
}

char *getenv(const char *name)
{
    size_t size = strlen(name);
    char *found = *find(name, size);

    return found == NULL ? NULL : found + size + 1;
}

/* Makes room for one more name; returns -1 with errno if there is no memory. */
static int grow(void)
{
    int wanted = capacity == 0 ? 16 : capacity * 2;
    char **larger;

    for (count = 0; environ[count] != NULL; count++)
        ;
    if (count < capacity)
        return 0;
    larger = malloc((wanted + 1) * sizeof *larger);
    if (larger == NULL)
        return -1;
    __builtin_memcpy(larger, environ, (count + 1) * sizeof *larger);
    if (capacity > 0)
        free(environ);
    environ = larger;
    capacity = wanted;
    return 0;
}

static int put(char *pair, size_t size)
{
    char **at = find(pair, size);

    if (*at == NULL) {
        if (grow() < 0)
            return -1;
        at = environ + count;
        at[1] = NULL;
    }
    *at = pair;
    return 0;
}

static int refuse(void)
{
    errno = EINVAL;
    return -1;
}

static void take_away(const char *name, size_t size)
{
    char **at = find(name, size);

    for (; *at != NULL; at++)
        *at = at[1];
}

int unsetenv(const char *name)
{
    if (*name == 0 || strchr(name, '=') != NULL)
        return refuse();
    take_away(name, strlen(name));
    return 0;
}

/* The string itself becomes part of the environment; without '=' the name is taken away. */
int putenv(char *pair)
{
    size_t size = strcspn(pair, "=");

    if (pair[size] == '=')
        return put(pair, size);
    take_away(pair, size);
    return 0;
}

int setenv(const char *name, const char *value, int overwrite)
{
    size_t size = strlen(name);
    char *pair;

    if (size == 0 || strchr(name, '=') != NULL)
        return refuse();
    if (!overwrite && *find(name, size) != NULL)
        return 0;
    pair = malloc(size + strlen(value) + 2);
    if (pair == NULL)
        return -1;
    __builtin_memcpy(pair, name, size);
    pair[size] = '=';
    strcpy(pair + size + 1, value);
    return put(pair, size);
}

int clearenv(void)
{
    *environ = NULL;
    return 0;
}
