/* What POSIX threads share: values by key, conditions, read-write locks; for a program of one. */
#include <errno.h>
#include <pthread.h>

#include <crs/clock.h>
#include <crs/refuse.h>

static struct {
    const void *value;
    int used;
} keys[PTHREAD_KEYS_MAX];

int pthread_attr_init(pthread_attr_t *attributes)
{
    attributes->__kind = 0;
    return 0;
}

int pthread_attr_destroy(pthread_attr_t *attributes)
{
    (void)attributes;
    return 0;
}

/* The destructor is called when a thread ends; the only one ends with the program. */
int pthread_key_create(pthread_key_t *key, void (*destroy)(void *))
{
    unsigned int i;

    (void)destroy;
    for (i = 0; i < PTHREAD_KEYS_MAX; i++)
        if (!keys[i].used) {
            keys[i].used = 1;
            keys[i].value = NULL;
            *key = i;
            return 0;
        }
    return EAGAIN;
}

int pthread_key_delete(pthread_key_t key)
{
    if (key >= PTHREAD_KEYS_MAX || !keys[key].used)
        return EINVAL;
    keys[key].used = 0;
    return 0;
}

int pthread_setspecific(pthread_key_t key, const void *value)
{
    if (key >= PTHREAD_KEYS_MAX || !keys[key].used)
        return EINVAL;
    keys[key].value = value;
    return 0;
}

void *pthread_getspecific(pthread_key_t key)
{
    return key < PTHREAD_KEYS_MAX && keys[key].used ? (void *)keys[key].value : NULL;
}

int pthread_cond_init(pthread_cond_t *condition, const pthread_condattr_t *attributes)
{
    (void)attributes;
    condition->__unused = 0;
    return 0;
}

int pthread_cond_destroy(pthread_cond_t *condition)
{
    (void)condition;
    return 0;
}

int pthread_cond_signal(pthread_cond_t *condition)
{
    (void)condition;
    return 0;
}

int pthread_cond_broadcast(pthread_cond_t *condition)
{
    (void)condition;
    return 0;
}

/* No other thread can signal: this would wait for ever. */
UNAVAILABLE(int, pthread_cond_wait, (pthread_cond_t *condition, pthread_mutex_t *mutex), EDEADLK,
            EDEADLK)

int pthread_cond_timedwait(pthread_cond_t *condition, pthread_mutex_t *mutex,
                           const struct timespec *until)
{
    double left_s = until->tv_sec - CRS_START + until->tv_nsec * 1e-9 - __crs_now(NULL);

    (void)condition;
    (void)mutex;
    if (left_s > 0)
        __crs_pass(left_s);
    return ETIMEDOUT;
}

int pthread_rwlock_init(pthread_rwlock_t *lock, const pthread_rwlockattr_t *attributes)
{
    (void)attributes;
    lock->__readers = lock->__written = 0;
    return 0;
}

int pthread_rwlock_destroy(pthread_rwlock_t *lock)
{
    return lock->__readers || lock->__written ? EBUSY : 0;
}

static int begin_reading(pthread_rwlock_t *lock, int error)
{
    if (lock->__written)
        return error;
    lock->__readers++;
    return 0;
}

static int begin_writing(pthread_rwlock_t *lock, int error)
{
    if (lock->__readers || lock->__written)
        return error;
    lock->__written = 1;
    return 0;
}

int pthread_rwlock_tryrdlock(pthread_rwlock_t *lock)
{
    return begin_reading(lock, EBUSY);
}

int pthread_rwlock_rdlock(pthread_rwlock_t *lock)
{
    return begin_reading(lock, EDEADLK);
}

int pthread_rwlock_trywrlock(pthread_rwlock_t *lock)
{
    return begin_writing(lock, EBUSY);
}

int pthread_rwlock_wrlock(pthread_rwlock_t *lock)
{
    return begin_writing(lock, EDEADLK);
}

int pthread_rwlock_unlock(pthread_rwlock_t *lock)
{
    if (lock->__written)
        lock->__written = 0;
    else if (lock->__readers > 0)
        lock->__readers--;
    else
        return EPERM;
    return 0;
}
