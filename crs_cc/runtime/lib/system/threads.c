/* POSIX threads for a program of one. A lock that it holds already can never be taken: that is a
 * deadlock, and an error instead of an endless wait. */
#include <errno.h>
#include <pthread.h>

#include <crs/refuse.h>

#define SELF 1

pthread_t pthread_self(void)
{
    return SELF;
}

int pthread_equal(pthread_t first, pthread_t second)
{
    return first == second;
}

UNAVAILABLE(int, pthread_create,
            (pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *),
             void *argument),
            EAGAIN, EAGAIN)

int pthread_join(pthread_t thread, void **result)
{
    (void)result;
    return thread == SELF ? EDEADLK : ESRCH;
}

int pthread_once(pthread_once_t *once, void (*routine)(void))
{
    if (!*once) {
        *once = 1;
        routine();
    }
    return 0;
}

int pthread_mutexattr_init(pthread_mutexattr_t *attributes)
{
    attributes->__kind = PTHREAD_MUTEX_DEFAULT;
    return 0;
}

int pthread_mutexattr_destroy(pthread_mutexattr_t *attributes)
{
    (void)attributes;
    return 0;
}

int pthread_mutexattr_settype(pthread_mutexattr_t *attributes, int kind)
{
    if (kind < PTHREAD_MUTEX_NORMAL || kind > PTHREAD_MUTEX_ERRORCHECK)
        return EINVAL;
    attributes->__kind = kind;
    return 0;
}

int pthread_mutexattr_gettype(const pthread_mutexattr_t *attributes, int *kind)
{
    *kind = attributes->__kind;
    return 0;
}

int pthread_mutex_init(pthread_mutex_t *mutex, const pthread_mutexattr_t *attributes)
{
    mutex->__held = 0;
    mutex->__kind = attributes ? attributes->__kind : PTHREAD_MUTEX_DEFAULT;
    return 0;
}

int pthread_mutex_destroy(pthread_mutex_t *mutex)
{
    return mutex->__held ? EBUSY : 0;
}

int pthread_mutex_lock(pthread_mutex_t *mutex)
{
    if (mutex->__held && mutex->__kind != PTHREAD_MUTEX_RECURSIVE)
        return EDEADLK;
    mutex->__held++;
    return 0;
}

int pthread_mutex_trylock(pthread_mutex_t *mutex)
{
    if (mutex->__held && mutex->__kind != PTHREAD_MUTEX_RECURSIVE)
        return EBUSY;
    mutex->__held++;
    return 0;
}

int pthread_mutex_unlock(pthread_mutex_t *mutex)
{
    if (!mutex->__held)
        return EPERM;
    mutex->__held--;
    return 0;
}
