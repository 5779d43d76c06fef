/* Scheduling (POSIX sched.h): all policies and priorities are accepted and have no effect. */
#include <errno.h>
#include <sched.h>

static int policy_in_use;
static struct sched_param parameters_in_use;

int sched_yield(void)
{
    return 0;
}

static int is_policy(int policy)
{
    if (policy >= SCHED_OTHER && policy <= SCHED_RR)
        return 1;
    errno = EINVAL;
    return 0;
}

static int least(int policy)
{
    return policy != SCHED_OTHER;
}

static int most(int policy)
{
    return policy == SCHED_OTHER ? 0 : 99;
}

static int set(int policy, const struct sched_param *parameters)
{
    if (parameters->sched_priority < least(policy) || parameters->sched_priority > most(policy)) {
        errno = EINVAL;
        return -1;
    }
    policy_in_use = policy;
    parameters_in_use = *parameters;
    return 0;
}

int sched_get_priority_min(int policy)
{
    return is_policy(policy) ? least(policy) : -1;
}

int sched_get_priority_max(int policy)
{
    return is_policy(policy) ? most(policy) : -1;
}

int sched_getscheduler(pid_t process)
{
    (void)process;
    return policy_in_use;
}

int sched_setparam(pid_t process, const struct sched_param *parameters)
{
    (void)process;
    return set(policy_in_use, parameters);
}

int sched_setscheduler(pid_t process, int policy, const struct sched_param *parameters)
{
    (void)process;
    return is_policy(policy) ? set(policy, parameters) : -1;
}

int sched_getparam(pid_t process, struct sched_param *parameters)
{
    (void)process;
    *parameters = parameters_in_use;
    return 0;
}
