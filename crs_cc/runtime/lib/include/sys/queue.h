/* BSD sys/queue.h: intrusive lists and queues. */
#ifndef _SYS_QUEUE_H
#define _SYS_QUEUE_H

#include <stddef.h>


/* Singly linked lists. */

#define SLIST_HEAD(name, type) \
    struct name { struct type *slh_first; }

#define SLIST_HEAD_INITIALIZER(head) \
    { NULL }

#define SLIST_ENTRY(type) \
    struct { struct type *sle_next; }

#define SLIST_FIRST(head) \
    ((head)->slh_first)

#define SLIST_EMPTY(head) \
    (SLIST_FIRST(head) == NULL)

#define SLIST_NEXT(element, field) \
    ((element)->field.sle_next)

#define SLIST_FOREACH(each, head, field) \
    for ((each) = SLIST_FIRST(head); (each) != NULL; (each) = SLIST_NEXT(each, field))

#define SLIST_INIT(head) \
    ((void)(SLIST_FIRST(head) = NULL))

#define SLIST_INSERT_HEAD(head, element, field) \
    do { \
        SLIST_NEXT(element, field) = SLIST_FIRST(head); \
        SLIST_FIRST(head) = (element); \
    } while (0)

#define SLIST_INSERT_AFTER(before, element, field) \
    do { \
        SLIST_NEXT(element, field) = SLIST_NEXT(before, field); \
        SLIST_NEXT(before, field) = (element); \
    } while (0)

#define SLIST_REMOVE_HEAD(head, field) \
    do { \
        SLIST_FIRST(head) = SLIST_NEXT(SLIST_FIRST(head), field); \
    } while (0)

#define SLIST_REMOVE_AFTER(element, field) \
    do { \
        SLIST_NEXT(element, field) = SLIST_NEXT(SLIST_NEXT(element, field), field); \
    } while (0)

#define SLIST_REMOVE(head, element, type, field) \
    do { \
        struct type **__at = &SLIST_FIRST(head); \
        while (*__at != (element)) \
            __at = &SLIST_NEXT(*__at, field); \
        *__at = SLIST_NEXT(element, field); \
    } while (0)

/* Singly linked queues. */

#define STAILQ_HEAD(name, type) \
    struct name { struct type *stqh_first, **stqh_last; }

#define STAILQ_HEAD_INITIALIZER(head) \
    { NULL, &(head).stqh_first }

#define STAILQ_ENTRY(type) \
    struct { struct type *stqe_next; }

#define STAILQ_FIRST(head) \
    ((head)->stqh_first)

#define STAILQ_EMPTY(head) \
    (STAILQ_FIRST(head) == NULL)

#define STAILQ_NEXT(element, field) \
    ((element)->field.stqe_next)

#define STAILQ_FOREACH(each, head, field) \
    for ((each) = STAILQ_FIRST(head); (each) != NULL; (each) = STAILQ_NEXT(each, field))

#define STAILQ_INIT(head) \
    do { \
        STAILQ_FIRST(head) = NULL; \
        (head)->stqh_last = &STAILQ_FIRST(head); \
    } while (0)

#define STAILQ_INSERT_HEAD(head, element, field) \
    do { \
        if ((STAILQ_NEXT(element, field) = STAILQ_FIRST(head)) == NULL) \
            (head)->stqh_last = &STAILQ_NEXT(element, field); \
        STAILQ_FIRST(head) = (element); \
    } while (0)

#define STAILQ_INSERT_TAIL(head, element, field) \
    do { \
        STAILQ_NEXT(element, field) = NULL; \
        *(head)->stqh_last = (element); \
        (head)->stqh_last = &STAILQ_NEXT(element, field); \
    } while (0)

#define STAILQ_INSERT_AFTER(head, before, element, field) \
    do { \
        if ((STAILQ_NEXT(element, field) = STAILQ_NEXT(before, field)) == NULL) \
            (head)->stqh_last = &STAILQ_NEXT(element, field); \
        STAILQ_NEXT(before, field) = (element); \
    } while (0)

#define STAILQ_REMOVE_HEAD(head, field) \
    do { \
        if ((STAILQ_FIRST(head) = STAILQ_NEXT(STAILQ_FIRST(head), field)) == NULL) \
            (head)->stqh_last = &STAILQ_FIRST(head); \
    } while (0)

#define STAILQ_REMOVE(head, element, type, field) \
    do { \
        struct type **__at = &STAILQ_FIRST(head); \
        while (*__at != (element)) \
            __at = &STAILQ_NEXT(*__at, field); \
        if ((*__at = STAILQ_NEXT(element, field)) == NULL) \
            (head)->stqh_last = __at; \
    } while (0)

/* The same under their name of NetBSD. */

#define SIMPLEQ_HEAD(name, type) \
    struct name { struct type *sqh_first, **sqh_last; }

#define SIMPLEQ_HEAD_INITIALIZER(head) \
    { NULL, &(head).sqh_first }

#define SIMPLEQ_ENTRY(type) \
    struct { struct type *sqe_next; }

#define SIMPLEQ_FIRST(head) \
    ((head)->sqh_first)

#define SIMPLEQ_EMPTY(head) \
    (SIMPLEQ_FIRST(head) == NULL)

#define SIMPLEQ_NEXT(element, field) \
    ((element)->field.sqe_next)

#define SIMPLEQ_FOREACH(each, head, field) \
    for ((each) = SIMPLEQ_FIRST(head); (each) != NULL; (each) = SIMPLEQ_NEXT(each, field))

#define SIMPLEQ_INIT(head) \
    do { \
        SIMPLEQ_FIRST(head) = NULL; \
        (head)->sqh_last = &SIMPLEQ_FIRST(head); \
    } while (0)

#define SIMPLEQ_INSERT_HEAD(head, element, field) \
    do { \
        if ((SIMPLEQ_NEXT(element, field) = SIMPLEQ_FIRST(head)) == NULL) \
            (head)->sqh_last = &SIMPLEQ_NEXT(element, field); \
        SIMPLEQ_FIRST(head) = (element); \
    } while (0)

#define SIMPLEQ_INSERT_TAIL(head, element, field) \
    do { \
        SIMPLEQ_NEXT(element, field) = NULL; \
        *(head)->sqh_last = (element); \
        (head)->sqh_last = &SIMPLEQ_NEXT(element, field); \
    } while (0)

#define SIMPLEQ_INSERT_AFTER(head, before, element, field) \
    do { \
        if ((SIMPLEQ_NEXT(element, field) = SIMPLEQ_NEXT(before, field)) == NULL) \
            (head)->sqh_last = &SIMPLEQ_NEXT(element, field); \
        SIMPLEQ_NEXT(before, field) = (element); \
    } while (0)

#define SIMPLEQ_REMOVE_HEAD(head, field) \
    do { \
        if ((SIMPLEQ_FIRST(head) = SIMPLEQ_NEXT(SIMPLEQ_FIRST(head), field)) == NULL) \
            (head)->sqh_last = &SIMPLEQ_FIRST(head); \
    } while (0)

#define SIMPLEQ_REMOVE(head, element, type, field) \
    do { \
        struct type **__at = &SIMPLEQ_FIRST(head); \
        while (*__at != (element)) \
            __at = &SIMPLEQ_NEXT(*__at, field); \
        if ((*__at = SIMPLEQ_NEXT(element, field)) == NULL) \
            (head)->sqh_last = __at; \
    } while (0)

/* Doubly linked lists. */

#define LIST_HEAD(name, type) \
    struct name { struct type *lh_first; }

#define LIST_HEAD_INITIALIZER(head) \
    { NULL }

#define LIST_ENTRY(type) \
    struct { struct type *le_next, **le_prev; }

#define LIST_FIRST(head) \
    ((head)->lh_first)

#define LIST_EMPTY(head) \
    (LIST_FIRST(head) == NULL)

#define LIST_NEXT(element, field) \
    ((element)->field.le_next)

#define LIST_FOREACH(each, head, field) \
    for ((each) = LIST_FIRST(head); (each) != NULL; (each) = LIST_NEXT(each, field))

#define LIST_INIT(head) \
    ((void)(LIST_FIRST(head) = NULL))

#define LIST_INSERT_HEAD(head, element, field) \
    do { \
        if ((LIST_NEXT(element, field) = LIST_FIRST(head)) != NULL) \
            LIST_FIRST(head)->field.le_prev = &LIST_NEXT(element, field); \
        LIST_FIRST(head) = (element); \
        (element)->field.le_prev = &LIST_FIRST(head); \
    } while (0)

#define LIST_INSERT_AFTER(before, element, field) \
    do { \
        if ((LIST_NEXT(element, field) = LIST_NEXT(before, field)) != NULL) \
            LIST_NEXT(element, field)->field.le_prev = &LIST_NEXT(element, field); \
        LIST_NEXT(before, field) = (element); \
        (element)->field.le_prev = &LIST_NEXT(before, field); \
    } while (0)

#define LIST_INSERT_BEFORE(behind, element, field) \
    do { \
        (element)->field.le_prev = (behind)->field.le_prev; \
        LIST_NEXT(element, field) = (behind); \
        *(behind)->field.le_prev = (element); \
        (behind)->field.le_prev = &LIST_NEXT(element, field); \
    } while (0)

#define LIST_REMOVE(element, field) \
    do { \
        if (LIST_NEXT(element, field) != NULL) \
            LIST_NEXT(element, field)->field.le_prev = (element)->field.le_prev; \
        *(element)->field.le_prev = LIST_NEXT(element, field); \
    } while (0)

/* Doubly linked queues. */

#define TAILQ_HEAD(name, type) \
    struct name { struct type *tqh_first, **tqh_last; }

#define TAILQ_HEAD_INITIALIZER(head) \
    { NULL, &(head).tqh_first }

#define TAILQ_ENTRY(type) \
    struct { struct type *tqe_next, **tqe_prev; }

#define TAILQ_FIRST(head) \
    ((head)->tqh_first)

#define TAILQ_EMPTY(head) \
    (TAILQ_FIRST(head) == NULL)

#define TAILQ_NEXT(element, field) \
    ((element)->field.tqe_next)

#define TAILQ_LAST(head, name) \
    (*((struct name *)(head)->tqh_last)->tqh_last)

#define TAILQ_PREV(element, name, field) \
    (*((struct name *)(element)->field.tqe_prev)->tqh_last)

#define TAILQ_FOREACH(each, head, field) \
    for ((each) = TAILQ_FIRST(head); (each) != NULL; (each) = TAILQ_NEXT(each, field))

#define TAILQ_FOREACH_REVERSE(each, head, name, field) \
    for ((each) = TAILQ_LAST(head, name); \
         (each) != NULL; \
         (each) = TAILQ_PREV(each, name, field))

#define TAILQ_INIT(head) \
    do { \
        TAILQ_FIRST(head) = NULL; \
        (head)->tqh_last = &TAILQ_FIRST(head); \
    } while (0)

#define TAILQ_INSERT_HEAD(head, element, field) \
    do { \
        if ((TAILQ_NEXT(element, field) = TAILQ_FIRST(head)) != NULL) \
            TAILQ_FIRST(head)->field.tqe_prev = &TAILQ_NEXT(element, field); \
        else \
            (head)->tqh_last = &TAILQ_NEXT(element, field); \
        TAILQ_FIRST(head) = (element); \
        (element)->field.tqe_prev = &TAILQ_FIRST(head); \
    } while (0)

#define TAILQ_INSERT_TAIL(head, element, field) \
    do { \
        TAILQ_NEXT(element, field) = NULL; \
        (element)->field.tqe_prev = (head)->tqh_last; \
        *(head)->tqh_last = (element); \
        (head)->tqh_last = &TAILQ_NEXT(element, field); \
    } while (0)

#define TAILQ_INSERT_AFTER(head, before, element, field) \
    do { \
        if ((TAILQ_NEXT(element, field) = TAILQ_NEXT(before, field)) != NULL) \
            TAILQ_NEXT(element, field)->field.tqe_prev = &TAILQ_NEXT(element, field); \
        else \
            (head)->tqh_last = &TAILQ_NEXT(element, field); \
        TAILQ_NEXT(before, field) = (element); \
        (element)->field.tqe_prev = &TAILQ_NEXT(before, field); \
    } while (0)

#define TAILQ_INSERT_BEFORE(behind, element, field) \
    do { \
        (element)->field.tqe_prev = (behind)->field.tqe_prev; \
        TAILQ_NEXT(element, field) = (behind); \
        *(behind)->field.tqe_prev = (element); \
        (behind)->field.tqe_prev = &TAILQ_NEXT(element, field); \
    } while (0)

#define TAILQ_REMOVE(head, element, field) \
    do { \
        if (TAILQ_NEXT(element, field) != NULL) \
            TAILQ_NEXT(element, field)->field.tqe_prev = (element)->field.tqe_prev; \
        else \
            (head)->tqh_last = (element)->field.tqe_prev; \
        *(element)->field.tqe_prev = TAILQ_NEXT(element, field); \
    } while (0)

#define TAILQ_CONCAT(to, from, field) \
    do { \
        if (!TAILQ_EMPTY(from)) { \
            *(to)->tqh_last = TAILQ_FIRST(from); \
            TAILQ_FIRST(from)->field.tqe_prev = (to)->tqh_last; \
            (to)->tqh_last = (from)->tqh_last; \
            TAILQ_INIT(from); \
        } \
    } while (0)

#define STAILQ_CONCAT(to, from) \
    do { \
        if (!STAILQ_EMPTY(from)) { \
            *(to)->stqh_last = STAILQ_FIRST(from); \
            (to)->stqh_last = (from)->stqh_last; \
            STAILQ_INIT(from); \
        } \
    } while (0)

/* Loops whose body may remove the element. */
#define __CRS_FOREACH_SAFE(each, first, following, next) \
    for ((each) = (first); (each) != NULL && ((next) = (following), 1); (each) = (next))
#define SLIST_FOREACH_SAFE(each, head, field, next) \
    __CRS_FOREACH_SAFE(each, SLIST_FIRST(head), SLIST_NEXT(each, field), next)
#define STAILQ_FOREACH_SAFE(each, head, field, next) \
    __CRS_FOREACH_SAFE(each, STAILQ_FIRST(head), STAILQ_NEXT(each, field), next)
#define LIST_FOREACH_SAFE(each, head, field, next) \
    __CRS_FOREACH_SAFE(each, LIST_FIRST(head), LIST_NEXT(each, field), next)
#define TAILQ_FOREACH_SAFE(each, head, field, next) \
    __CRS_FOREACH_SAFE(each, TAILQ_FIRST(head), TAILQ_NEXT(each, field), next)

/* Circular queues: both ends are linked to the head. */
#define CIRCLEQ_HEAD(name, type) \
    struct name { \
        struct type *cqh_first, *cqh_last; \
    }

#define CIRCLEQ_HEAD_INITIALIZER(head) \
    { (void *)&(head), (void *)&(head) }

#define CIRCLEQ_ENTRY(type) \
    struct { \
        struct type *cqe_next, *cqe_prev; \
    }

#define CIRCLEQ_FIRST(head) \
    ((head)->cqh_first)

#define CIRCLEQ_LAST(head) \
    ((head)->cqh_last)

#define CIRCLEQ_EMPTY(head) \
    (CIRCLEQ_FIRST(head) == (void *)(head))

#define CIRCLEQ_NEXT(element, field) \
    ((element)->field.cqe_next)

#define CIRCLEQ_PREV(element, field) \
    ((element)->field.cqe_prev)

#define CIRCLEQ_LOOP_NEXT(head, element, field) \
    (CIRCLEQ_NEXT(element, field) == (void *)(head) ? CIRCLEQ_FIRST(head) \
                                                    : CIRCLEQ_NEXT(element, field))

#define CIRCLEQ_LOOP_PREV(head, element, field) \
    (CIRCLEQ_PREV(element, field) == (void *)(head) ? CIRCLEQ_LAST(head) \
                                                    : CIRCLEQ_PREV(element, field))

#define CIRCLEQ_FOREACH(each, head, field) \
    for ((each) = CIRCLEQ_FIRST(head); \
         (each) != (const void *)(head); \
         (each) = CIRCLEQ_NEXT(each, field))

#define CIRCLEQ_FOREACH_REVERSE(each, head, field) \
    for ((each) = CIRCLEQ_LAST(head); \
         (each) != (const void *)(head); \
         (each) = CIRCLEQ_PREV(each, field))

#define CIRCLEQ_INIT(head) \
    do { \
        CIRCLEQ_FIRST(head) = (void *)(head); \
        CIRCLEQ_LAST(head) = (void *)(head); \
    } while (0)

#define CIRCLEQ_INSERT_AFTER(head, before, element, field) \
    do { \
        CIRCLEQ_NEXT(element, field) = CIRCLEQ_NEXT(before, field); \
        CIRCLEQ_PREV(element, field) = (before); \
        if (CIRCLEQ_NEXT(before, field) == (void *)(head)) \
            CIRCLEQ_LAST(head) = (element); \
        else \
            CIRCLEQ_PREV(CIRCLEQ_NEXT(before, field), field) = (element); \
        CIRCLEQ_NEXT(before, field) = (element); \
    } while (0)

#define CIRCLEQ_INSERT_BEFORE(head, behind, element, field) \
    do { \
        CIRCLEQ_NEXT(element, field) = (behind); \
        CIRCLEQ_PREV(element, field) = CIRCLEQ_PREV(behind, field); \
        if (CIRCLEQ_PREV(behind, field) == (void *)(head)) \
            CIRCLEQ_FIRST(head) = (element); \
        else \
            CIRCLEQ_NEXT(CIRCLEQ_PREV(behind, field), field) = (element); \
        CIRCLEQ_PREV(behind, field) = (element); \
    } while (0)

#define CIRCLEQ_INSERT_HEAD(head, element, field) \
    do { \
        CIRCLEQ_NEXT(element, field) = CIRCLEQ_FIRST(head); \
        CIRCLEQ_PREV(element, field) = (void *)(head); \
        if (CIRCLEQ_LAST(head) == (void *)(head)) \
            CIRCLEQ_LAST(head) = (element); \
        else \
            CIRCLEQ_PREV(CIRCLEQ_FIRST(head), field) = (element); \
        CIRCLEQ_FIRST(head) = (element); \
    } while (0)

#define CIRCLEQ_INSERT_TAIL(head, element, field) \
    do { \
        CIRCLEQ_NEXT(element, field) = (void *)(head); \
        CIRCLEQ_PREV(element, field) = CIRCLEQ_LAST(head); \
        if (CIRCLEQ_FIRST(head) == (void *)(head)) \
            CIRCLEQ_FIRST(head) = (element); \
        else \
            CIRCLEQ_NEXT(CIRCLEQ_LAST(head), field) = (element); \
        CIRCLEQ_LAST(head) = (element); \
    } while (0)

#define CIRCLEQ_REMOVE(head, element, field) \
    do { \
        if (CIRCLEQ_NEXT(element, field) == (void *)(head)) \
            CIRCLEQ_LAST(head) = CIRCLEQ_PREV(element, field); \
        else \
            CIRCLEQ_PREV(CIRCLEQ_NEXT(element, field), field) = CIRCLEQ_PREV(element, field); \
        if (CIRCLEQ_PREV(element, field) == (void *)(head)) \
            CIRCLEQ_FIRST(head) = CIRCLEQ_NEXT(element, field); \
        else \
            CIRCLEQ_NEXT(CIRCLEQ_PREV(element, field), field) = CIRCLEQ_NEXT(element, field); \
    } while (0)

#endif
