/* & of a value. */
int main(void)
{
    int *p = &(3 + 4); // error: address
    return *p;
}
