/* A recursive reader of JSON into a tree, an evaluator of paths, a printer. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum { NUL, BOOL, NUMBER, STRING, ARRAY, OBJECT } Kind;

typedef struct value {
    Kind kind;
    union { int truth; double number; char *string; struct value *first; } as;
    char *key;
    struct value *next;
} Value;

static const char *at;

static void skip(void) { while (isspace((unsigned char) *at)) at++; }
static int took(char c) { skip(); return *at == c ? at++, 1 : 0; }
static Value *value(void);

static char *string(void)
{
    char *out = malloc(strlen(at) + 1), *p = out;
    for (; *at && *at != '"'; at++)
        if (*at == '\\')
            switch (*++at) {
            case 'n': *p++ = '\n'; break;
            case 'u': *p++ = (char) strtol((char[]) { at[3], at[4], 0 }, NULL, 16); at += 4; break;
            default: *p++ = *at;
            }
        else
            *p++ = *at;
    at++;
    *p = 0;
    return realloc(out, (size_t) (p - out) + 1);
}

static Value *items(Value *v, char close)
{
    Value **tail = &v->as.first;
    if (took(close))
        return v;
    do {
        char *key = NULL;
        if (v->kind == OBJECT) {
            took('"');
            key = string();
            took(':');
        }
        *tail = value();
        (*tail)->key = key;
        tail = &(*tail)->next;
    } while (took(','));
    took(close);
    return v;
}

static Value *value(void)
{
    Value *v = calloc(1, sizeof *v);
    if (took('[')) {
        v->kind = ARRAY;
        return items(v, ']');
    }
    if (took('{')) {
        v->kind = OBJECT;
        return items(v, '}');
    }
    if (took('"')) {
        v->kind = STRING;
        v->as.string = string();
    } else if (isalpha((unsigned char) *at)) {
        v->kind = *at == 'n' ? NUL : BOOL;
        v->as.truth = *at == 't';
        while (isalpha((unsigned char) *at))
            at++;
    } else {
        char *end;
        v->kind = NUMBER;
        v->as.number = strtod(at, &end);
        at = end;
    }
    return v;
}

static void print(const Value *v)
{
    switch (v->kind) {
    case NUL: printf("null"); break;
    case BOOL: printf(v->as.truth ? "true" : "false"); break;
    case NUMBER: printf("%.15g", v->as.number); break;
    case STRING: printf("'%s'", v->as.string); break;
    case ARRAY: case OBJECT:
        putchar("[{"[v->kind == OBJECT]);
        for (const Value *e = v->as.first; e; e = e->next) {
            if (e->key)
                printf("%s=", e->key);
            print(e);
            if (e->next)
                printf(", ");
        }
        putchar("]}"[v->kind == OBJECT]);
    }
}

static const Value *get(const Value *v, const char *key)
{
    for (v = v->as.first; v && strcmp(v->key, key); v = v->next)
        ;
    return v;
}

static int discard(Value *v)
{
    int count = 1;
    if (v->kind >= ARRAY)
        for (Value *e = v->as.first, *next; e; e = next) {
            next = e->next;
            count += discard(e);
        }
    else if (v->kind == STRING)
        free(v->as.string);
    free(v->key);
    free(v);
    return count;
}

int main(void)
{
    at = "{ \"name\": \"scout \\\"1\\\"\", \"pose\": [1.5, -2e3, 0.1], \"on\": true,\n"
         "  \"deep\": [[], {\"x\": null, \"y\": [false]}], \"code\": \"\\u0041\\n\" }";
    Value *all = value();
    print(all);
    printf("\n%s %g %d\n", get(all, "name")->as.string, get(all, "pose")->as.first->as.number,
           get(all, "none") == NULL);
    printf("%d values\n", discard(all));
    return 0;
}
