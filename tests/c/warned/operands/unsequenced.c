/* A variable is changed and used in one expression, in an order that C leaves open. */
static int twice(int a, int b)
{
    return a + b;
}

int main(void)
{
    int a[4] = { 0 }, i = 0, j = 0, *p = a;
    int sum = i++ + i++; // warning: multiple unsequenced modifications to 'i'
    int pair[] = { i++, i };

    i = i++ + 1; // warning: multiple unsequenced modifications to 'i'
    a[i] = i++; // warning: unsequenced modification and access to 'i'
    j = i++ * i; // warning: unsequenced modification and access to 'i'
    j += twice(j++, 1);
    j = twice(i++, i); // warning: unsequenced modification and access to 'i'
    i += j > 2 ? i-- : 0; // warning: multiple unsequenced modifications to 'i'
    *p++ = *p; // warning: unsequenced modification and access to 'p'
    i = (i++, 5);
    i = i + 1;
    p = a, *p++ = 4, p++;
    for (j = 0; j < 3; a[j] = j, j++)
        ;
    i = twice(i++, 2);
    i = sum + pair[0];
    return i > j ? i-- : i++;
}
