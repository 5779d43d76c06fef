/* What a program of one thread does with the means of several: keys, conditions, locks. */
// gcc options: -pthread
#include <errno.h>
#include <pthread.h>
#include <stdio.h>
#include <time.h>

static pthread_cond_t changed = PTHREAD_COND_INITIALIZER, other;
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_rwlock_t map = PTHREAD_RWLOCK_INITIALIZER, drawn;
static pthread_key_t first, second;

int main(void) {
    struct timespec until;
    pthread_attr_t attributes;
    int number = 7;
    printf("%d", pthread_attr_init(&attributes));
    printf(" %d\n", pthread_attr_destroy(&attributes));
    printf("%d", pthread_key_create(&first, NULL));
    printf(" %d\n", pthread_key_create(&second, NULL));
    printf("%d %d\n", first != second, pthread_getspecific(first) == NULL);
    pthread_setspecific(first, &number);
    pthread_setspecific(second, "text");
    printf("%d %s\n", *(int *) pthread_getspecific(first), (char *) pthread_getspecific(second));
    printf("%d\n", pthread_key_delete(second));
    printf("%d", pthread_cond_init(&other, NULL));
    printf(" %d\n", pthread_cond_signal(&other));
    printf("%d %d\n", pthread_cond_broadcast(&changed), pthread_cond_destroy(&other));
    pthread_mutex_lock(&lock);
    clock_gettime(CLOCK_REALTIME, &until);
    until.tv_nsec += 30000000;
    until.tv_sec += until.tv_nsec / 1000000000;
    until.tv_nsec %= 1000000000;
    printf("%d\n", pthread_cond_timedwait(&changed, &lock, &until) == ETIMEDOUT);
    pthread_mutex_unlock(&lock);
    pthread_rwlock_init(&drawn, NULL);
    printf("%d %d\n", pthread_rwlock_rdlock(&map), pthread_rwlock_tryrdlock(&map));
    printf("%d\n", pthread_rwlock_trywrlock(&map) == EBUSY);
    printf("%d", pthread_rwlock_unlock(&map));
    printf(" %d\n", pthread_rwlock_unlock(&map));
    printf("%d", pthread_rwlock_wrlock(&map));
    printf(" %d\n", pthread_rwlock_tryrdlock(&map) == EBUSY);
    printf("%d", pthread_rwlock_unlock(&map));
    printf(" %d %d\n", pthread_rwlock_destroy(&map), pthread_rwlock_destroy(&drawn));
    return 0;
}
