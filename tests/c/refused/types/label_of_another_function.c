/* A goto finds labels of its own function only. */
static void other(void)
{
there:;
}

int main(void)
{
    other();
    goto there; // error: use of undeclared label 'there'
}
